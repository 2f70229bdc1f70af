// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonCells.h"

#include "CellVisits.h"
#include "Geometry/PolygonTriangulation.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// visit(cell, npts, ids) for every polygon and then every strip.
template <typename VisitPolygon, typename VisitStrip>
void VisitFaces(vtkPolyData* input, const VisitPolygon& visitPolygon, const VisitStrip& visitStrip)
{
  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  VisitCells(input->GetPolys(), firstPolygon, visitPolygon);
  VisitCells(input->GetStrips(), firstPolygon + input->GetNumberOfPolys(), visitStrip);
}

TriangulatedCells WrongCells(vtkPolyData* input)
{
  TriangulatedCells wrong;
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  const auto look = [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids)
  {
    if (HasWrongId(npts, ids, numberOfPoints))
    {
      wrong.Triangles.push_back({ None, None, None });
      wrong.CellOfTriangle.push_back(cell);
    }
  };
  VisitFaces(input, look, look);
  return wrong;
}

/// Corners at one or two positions.
void AddShape(const std::vector<Index>& corners, const std::vector<Vector3>& points,
  std::vector<std::array<Vector3, 3>>& shapes)
{
  if (!corners.empty())
  {
    const Vector3& first = points[corners.front()];
    const auto other = std::find_if(
      corners.begin(), corners.end(), [&](Index corner) { return points[corner] != first; });
    const Vector3& last = other == corners.end() ? first : points[*other];
    shapes.push_back({ first, last, last });
  }
}
}

TriangulatedCells TriangulateCells(vtkPolyData* input, const std::vector<Vector3>& points)
{
  TriangulatedCells found = WrongCells(input);
  if (!found.Triangles.empty())
  {
    return found;
  }
  PolygonTriangulation triangulation(points);
  std::vector<Index> corners;
  const auto add = [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids, bool isStrip)
  {
    corners.assign(ids, ids + npts);
    const bool isTriangle = npts == 3; // as it is, even if it has no area
    const bool isAdded = isStrip || isTriangle ? AppendStrip(corners, found.Triangles)
                                               : triangulation.Append(corners, found.Triangles);
    found.CellOfTriangle.resize(found.Triangles.size(), cell);
    if (!isAdded)
    {
      found.FirstLeftOut = found.LeftOut++ == 0 ? cell : found.FirstLeftOut;
      AddShape(corners, points, found.ShapesLeftOut);
    }
  };
  VisitFaces(
    input,
    [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids) { add(cell, npts, ids, false); },
    [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids) { add(cell, npts, ids, true); });
  return found;
}
}
