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
#include <map>
#include <set>

namespace bonedecimate
{
namespace
{
/// Point array of a strip: 1 where it is connected to the rest and must not change, 0 at other
/// points.
constexpr const char* RimArrayName = "bonedecimate.rim";

/// Cell array of a strip: of the edge after each corner, 1 if other triangles have it, too.
constexpr const char* CutsArrayName = "bonedecimate.cuts";

/// Around what phase 1 did not change: the first is fine, the last is coarse and becomes
/// constrained, as a rim.
constexpr int Rings = 4;

vtkIdType FirstPolygon(vtkPolyData* surface)
{
  return surface->GetNumberOfVerts() + surface->GetNumberOfLines();
}

/// Calls visit(cell, corners) for each polygon.
template <typename Visit>
void ForEachPolygon(vtkPolyData* surface, const Visit& visit)
{
  vtkNew<vtkIdList> corners;
  surface->BuildCells();
  for (vtkIdType cell = FirstPolygon(surface); cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    visit(static_cast<std::size_t>(cell), *corners);
  }
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

/// Adds an array that marks the points of cells that may not change.
void MarkRim(vtkPolyData* surface, const std::vector<bool>& mayChange)
{
  vtkNew<vtkUnsignedCharArray> rim;
  rim->SetName(RimArrayName);
  rim->SetNumberOfTuples(surface->GetNumberOfPoints());
  rim->Fill(0);
  ForEachPolygon(surface,
    [&](std::size_t cell, vtkIdList& corners)
    {
      for (vtkIdType i = 0; !mayChange[cell] && i < corners.GetNumberOfIds(); ++i)
      {
        rim->SetValue(corners.GetId(i), 1);
      }
    });
  surface->GetPointData()->AddArray(rim);
}

/// For each point, the first one with its coordinates.
std::vector<vtkIdType> FirstOfEqual(vtkPolyData* surface)
{
  std::map<Position, vtkIdType> known;
  std::vector<vtkIdType> first;
  first.reserve(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    first.push_back(known.emplace(PositionOf(surface->GetPoint(i)), i).first->second);
  }
  return first;
}

/// Calls visit(i, edge) for each edge of a polygon, from its corner i, as an ascending pair.
template <typename Visit>
void ForEachEdge(vtkIdList& corners, const std::vector<vtkIdType>& points, const Visit& visit)
{
  const vtkIdType count = corners.GetNumberOfIds();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType from = points[static_cast<std::size_t>(corners.GetId(i))];
    const vtkIdType to = points[static_cast<std::size_t>(corners.GetId((i + 1) % count))];
    visit(static_cast<int>(i), std::array<vtkIdType, 2>{ std::min(from, to), std::max(from, to) });
  }
}

/// Edges of cells that other cells have, too.
void MarkCuts(vtkPolyData* surface, const std::vector<bool>& cells)
{
  const std::vector<vtkIdType> points = FirstOfEqual(surface);
  std::set<std::array<vtkIdType, 2>> others;
  ForEachPolygon(surface,
    [&](std::size_t cell, vtkIdList& corners)
    {
      if (!cells[cell])
      {
        ForEachEdge(
          corners, points, [&](int, const std::array<vtkIdType, 2>& edge) { others.insert(edge); });
      }
    });
  vtkNew<vtkUnsignedCharArray> cuts;
  cuts->SetName(CutsArrayName);
  cuts->SetNumberOfComponents(3);
  cuts->SetNumberOfTuples(surface->GetNumberOfCells());
  cuts->Fill(0);
  ForEachPolygon(surface,
    [&](std::size_t cell, vtkIdList& corners)
    {
      if (cells[cell])
      {
        ForEachEdge(corners, points,
          [&](int i, const std::array<vtkIdType, 2>& edge) {
            cuts->SetComponent(static_cast<vtkIdType>(cell), i, others.count(edge) > 0 ? 1.0 : 0.0);
          });
      }
    });
  surface->GetCellData()->AddArray(cuts);
}

vtkSmartPointer<vtkPolyData> CopyOf(vtkPolyData* surface)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface);
  copy->BuildCells();
  return copy;
}
}

//------------------------------------------------------------------------------
std::vector<bool> CellsAt(vtkPolyData* surface, const Positions& positions)
{
  std::vector<bool> isThere;
  isThere.reserve(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    isThere.push_back(Contains(positions, surface->GetPoint(i)));
  }
  std::vector<bool> cells(static_cast<std::size_t>(surface->GetNumberOfCells()), false);
  ForEachPolygon(surface,
    [&](std::size_t cell, vtkIdList& corners)
    {
      cells[cell] = std::any_of(corners.begin(), corners.end(),
        [&](vtkIdType corner) { return isThere[static_cast<std::size_t>(corner)]; });
    });
  return cells;
}

//------------------------------------------------------------------------------
std::vector<bool> RingsAround(vtkPolyData* surface, std::vector<bool> cells)
{
  for (int ring = 1; ring < Rings; ++ring)
  {
    std::vector<bool> points(static_cast<std::size_t>(surface->GetNumberOfPoints()), false);
    ForEachPolygon(surface,
      [&](std::size_t cell, vtkIdList& corners)
      {
        for (vtkIdType i = 0; cells[cell] && i < corners.GetNumberOfIds(); ++i)
        {
          points[static_cast<std::size_t>(corners.GetId(i))] = true;
        }
      });
    ForEachPolygon(surface,
      [&](std::size_t cell, vtkIdList& corners)
      {
        cells[cell] = std::any_of(corners.begin(), corners.end(),
          [&](vtkIdType corner) { return points[static_cast<std::size_t>(corner)]; });
      });
  }
  return cells;
}

//------------------------------------------------------------------------------
StripParts CutStrips(
  vtkPolyData* surface, const std::vector<bool>& mayChange, const std::vector<bool>& around)
{
  if (surface->GetNumberOfCells() == 0)
  {
    return { vtkSmartPointer<vtkPolyData>::New(), surface };
  }
  const auto copy = CopyOf(surface);
  std::vector<bool> cells = mayChange;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    cells[i] = cells[i] || around[i];
  }
  StripParts parts;
  parts.Rest = Part(copy, cells, false);
  MarkRim(copy, mayChange);
  MarkCuts(copy, cells);
  parts.Strip = Part(copy, cells, true);
  return parts;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> OnlyCells(vtkPolyData* surface, const std::vector<bool>& cells)
{
  return surface->GetNumberOfCells() == 0 ? vtkSmartPointer<vtkPolyData>(surface)
                                          : Part(CopyOf(surface), cells, true);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithoutCells(vtkPolyData* surface, const std::vector<bool>& cells)
{
  return surface->GetNumberOfCells() == 0 ? vtkSmartPointer<vtkPolyData>(surface)
                                          : Part(CopyOf(surface), cells, false);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> CutOut(vtkPolyData* surface, const std::vector<bool>& cells)
{
  if (surface->GetNumberOfCells() == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  const auto copy = CopyOf(surface);
  MarkCuts(copy, cells);
  return Part(copy, cells, true);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithoutArrays(vtkPolyData* surface)
{
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->SetPoints(surface->GetPoints());
  bare->SetPolys(surface->GetPolys());
  for (const char* name : { "BoundaryLabels", CellLabelsName })
  {
    if (vtkDataArray* labels = surface->GetCellData()->GetArray(name))
    {
      const auto ofPolygons = vtk::TakeSmartPointer(labels->NewInstance());
      ofPolygons->SetName(name);
      ofPolygons->SetNumberOfComponents(labels->GetNumberOfComponents());
      ofPolygons->InsertTuples(0, bare->GetNumberOfCells(), FirstPolygon(surface), labels);
      bare->GetCellData()->AddArray(ofPolygons);
    }
  }
  bare->GetFieldData()->ShallowCopy(surface->GetFieldData());
  return bare;
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
std::vector<std::array<vtkIdType, 2>> TakeCuts(vtkPolyData* strips)
{
  std::vector<std::array<vtkIdType, 2>> edges;
  const vtkSmartPointer<vtkDataArray> cuts = strips->GetCellData()->GetArray(CutsArrayName);
  if (cuts)
  {
    ForEachPolygon(strips,
      [&](std::size_t cell, vtkIdList& corners)
      {
        for (int i = 0; i < 3; ++i)
        {
          if (cuts->GetComponent(static_cast<vtkIdType>(cell), i) != 0.0)
          {
            edges.push_back({ corners.GetId(i), corners.GetId((i + 1) % 3) });
          }
        }
      });
    strips->GetCellData()->RemoveArray(CutsArrayName);
  }
  return edges;
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
