// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceExtents.h"

#include "Mesh/Statistics.h"
#include "Mesh/SurfaceParts.h"
#include "SurfaceDistances.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"

#include <map>

namespace bonedecimate
{
namespace
{
/// @param triangles Triangles alone. Positions are relative to the low corner of their box.
Surface SurfaceOf(vtkPolyData* triangles)
{
  Surface surface;
  const double* const box = triangles->GetBounds();
  const Vector3 low(box[0], box[2], box[4]);
  for (vtkIdType point = 0; point < triangles->GetNumberOfPoints(); ++point)
  {
    surface.Points.push_back(Vector3(triangles->GetPoint(point)) - low);
  }
  const auto cells = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    surface.Triangles.push_back(
      { static_cast<Index>(ids[0]), static_cast<Index>(ids[1]), static_cast<Index>(ids[2]) });
  }
  return surface;
}

/// Rounded down to one digit: 3.5 is 3, 0.035 is 0.03. Scales by powers of ten alone, so that the
/// result is the number that its text is read as.
double RoundedDown(double size)
{
  double scale = 1.0;
  for (; size > 0.0 && size * scale < 1.0; scale *= 10.0)
  {
  }
  double unit = 1.0;
  for (; size / unit >= 10.0; unit *= 10.0)
  {
  }
  return static_cast<double>(static_cast<int>(size * scale / unit)) * unit / scale;
}

double LongestSide(const PartExtent& extent)
{
  return (extent.High - extent.Low).maxCoeff();
}

std::map<std::int64_t, Index> PartsOfLabels(const std::vector<NamedLabel>& labels)
{
  std::map<std::int64_t, Index> parts;
  for (const NamedLabel& label : labels)
  {
    parts.emplace(label.Value, static_cast<Index>(parts.size()));
  }
  return parts;
}

/// Triangles that bound a part; all points remain.
Surface BoundaryOf(const Surface& surface, const SurfaceParts& parts, Index part)
{
  Surface boundary;
  boundary.Points = surface.Points;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const PartSides& sides = parts.OfTriangle[t];
    if (sides[0] == part || sides[1] == part)
    {
      boundary.Triangles.push_back(surface.Triangles[t]);
    }
  }
  return boundary;
}
}

SpeckFigures FindSpecks(vtkPolyData* surface)
{
  constexpr double ratioOfDiagonal = 0.02;
  const auto triangles = MergedTriangles(surface);
  SpeckFigures figures;
  if (triangles->GetNumberOfPolys() == 0)
  {
    return figures;
  }
  figures.Size = RoundedDown(ratioOfDiagonal * triangles->GetLength());
  const Surface whole = SurfaceOf(triangles);
  double area = 0.0;
  for (const PartExtent& extent :
    MeasureParts(whole.Points, whole.Triangles, ComponentsAsParts(whole)))
  {
    const bool isSpeck = LongestSide(extent) < figures.Size;
    ++figures.Components;
    figures.Specks += isSpeck ? 1 : 0;
    figures.AreaRatio += isSpeck ? extent.Area : 0.0;
    area += extent.Area;
  }
  figures.AreaRatio /= area > 0.0 ? area : 1.0;
  return figures;
}

std::vector<LabelExtent> LabelExtents(vtkPolyData* surface, const std::vector<NamedLabel>& labels)
{
  std::vector<LabelExtent> extents;
  const auto triangles = MergedTriangles(surface);
  vtkDataArray* const pairs = triangles->GetCellData()->GetArray(LabelsOfSidesName);
  if (labels.empty() || !pairs || pairs->GetNumberOfComponents() != 2)
  {
    return extents;
  }
  const std::map<std::int64_t, Index> partOf = PartsOfLabels(labels);
  SurfaceParts parts;
  parts.Count = static_cast<Index>(partOf.size());
  const auto part = [&](vtkIdType cell, int side)
  {
    const auto found = partOf.find(static_cast<std::int64_t>(pairs->GetComponent(cell, side)));
    return found == partOf.end() ? None : found->second;
  };
  for (vtkIdType cell = 0; cell < pairs->GetNumberOfTuples(); ++cell)
  {
    parts.OfTriangle.push_back({ part(cell, 0), part(cell, 1) });
  }
  const Surface whole = SurfaceOf(triangles);
  const std::vector<PartExtent> measured = MeasureParts(whole.Points, whole.Triangles, parts);
  for (const NamedLabel& label : labels)
  {
    const Index number = partOf.at(label.Value);
    const PartExtent& extent = measured[static_cast<std::size_t>(number)];
    extents.push_back({ label, extent.Triangles,
      FindComponents(BoundaryOf(whole, parts, number)).Count, extent.Area, extent.Volume });
  }
  return extents;
}
}
