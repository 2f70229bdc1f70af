// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryStrips.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bonedecimate
{
namespace
{
/// Point array of a strip: 1 where it is connected to the rest and must not change, 0 at other points.
constexpr const char* RimArrayName = "bonedecimate.rim";

/// Rings around the shared positions: the first is constrained and fine, the last is coarse and becomes constrained, as a rim.
constexpr int Rings = 4;

/// Marks the polygons with a marked corner, then all their corners; once for each ring.
std::vector<bool> CellsAround(vtkPolyData* surface, const Positions& shared)
{
  std::vector<bool> points(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = Contains(shared, surface->GetPoint(static_cast<vtkIdType>(i)));
  }
  const vtkIdType first = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  std::vector<bool> cells(static_cast<std::size_t>(surface->GetNumberOfCells()), false);
  vtkNew<vtkIdList> corners;
  for (int ring = 0; ring < Rings; ++ring)
  {
    std::vector<bool> reached = points;
    for (vtkIdType cell = first; cell < surface->GetNumberOfCells(); ++cell)
    {
      surface->GetCellPoints(cell, corners);
      bool isNear = false;
      for (const vtkIdType corner : *corners)
      {
        isNear = isNear || points[static_cast<std::size_t>(corner)];
      }
      for (vtkIdType i = 0; isNear && i < corners->GetNumberOfIds(); ++i)
      {
        reached[static_cast<std::size_t>(corners->GetId(i))] = true;
      }
      cells[static_cast<std::size_t>(cell)] = cells[static_cast<std::size_t>(cell)] || isNear;
    }
    points = reached;
  }
  return cells;
}

/// The cells with that mark, with their points and all arrays.
vtkSmartPointer<vtkPolyData> Part(vtkPolyData* surface, const std::vector<bool>& marks, bool value)
{
  vtkNew<vtkIdList> ids;
  for (std::size_t cell = 0; cell < marks.size(); ++cell)
  {
    if (marks[cell] == value)
    {
      ids->InsertNextId(static_cast<vtkIdType>(cell));
    }
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  part->SetPoints(points);
  part->AllocateEstimate(ids->GetNumberOfIds() + 1, 3);
  // Ids are copied like every other value, not merged or made anew.
  part->GetPointData()->CopyAllOn();
  part->GetCellData()->CopyAllOn();
  part->GetPointData()->CopyAllocate(surface->GetPointData());
  part->GetCellData()->CopyAllocate(surface->GetCellData());
  part->CopyCells(surface, ids);
  part->GetFieldData()->ShallowCopy(surface->GetFieldData());
  return part;
}

/// Of points of marked cells that another cell has, too.
void MarkRim(vtkPolyData* surface, const std::vector<bool>& marks)
{
  vtkNew<vtkUnsignedCharArray> rim;
  rim->SetName(RimArrayName);
  rim->SetNumberOfTuples(surface->GetNumberOfPoints());
  rim->Fill(0);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    if (!marks[static_cast<std::size_t>(cell)])
    {
      surface->GetCellPoints(cell, corners);
      for (const vtkIdType corner : *corners)
      {
        rim->SetValue(corner, 1);
      }
    }
  }
  surface->GetPointData()->AddArray(rim);
}
}

//------------------------------------------------------------------------------
StripParts CutStrips(vtkPolyData* surface, const Positions& shared)
{
  if (surface->GetNumberOfCells() == 0)
  {
    return { vtkSmartPointer<vtkPolyData>::New(), surface };
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface);
  copy->BuildCells();
  const std::vector<bool> marks = CellsAround(copy, shared);
  MarkRim(copy, marks);
  StripParts parts{ Part(copy, marks, true), Part(copy, marks, false) };
  parts.Rest->GetPointData()->RemoveArray(RimArrayName);
  return parts;
}

//------------------------------------------------------------------------------
std::vector<char> TakeRim(vtkPolyData* strips)
{
  std::vector<char> isOnRim;
  const vtkSmartPointer<vtkDataArray> rim = strips->GetPointData()->GetArray(RimArrayName);
  for (vtkIdType point = 0; rim && point < rim->GetNumberOfTuples(); ++point)
  {
    isOnRim.push_back(rim->GetComponent(point, 0) != 0.0 ? 1 : 0);
  }
  strips->GetPointData()->RemoveArray(RimArrayName);
  return isOnRim;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  append->AddInputData(vtkNew<vtkPolyData>());
  for (vtkPolyData* part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  const auto filled = std::find_if(
    parts.begin(), parts.end(), [](vtkPolyData* part) { return part->GetNumberOfPoints() > 0; });
  if (filled != parts.end())
  {
    append->GetOutput()->GetFieldData()->ShallowCopy((*filled)->GetFieldData());
  }
  return append->GetOutput();
}

//------------------------------------------------------------------------------
std::vector<double> DistancesTo(vtkPolyData* surface, vtkPoints* points)
{
  const vtkIdType count = points ? points->GetNumberOfPoints() : 0;
  std::vector<double> distances(
    static_cast<std::size_t>(count), std::numeric_limits<double>::infinity());
  if (surface->GetNumberOfPolys() == 0)
  {
    return distances;
  }
  vtkNew<vtkPolyData> triangles;
  triangles->SetPoints(surface->GetPoints());
  triangles->SetPolys(surface->GetPolys());
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(triangles);
  locator->BuildLocator();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double position[3];
    vtkIdType cell = -1;
    int part = 0;
    double squared = 0.0; // mm^2
    locator->FindClosestPoint(points->GetPoint(i), position, cell, part, squared);
    distances[static_cast<std::size_t>(i)] = std::sqrt(squared);
  }
  return distances;
}
}
