// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Angles.h"
#include "Random.h"
#include "Shapes.h"

#include <algorithm>
#include <functional>

namespace bonedecimate::testsupport
{
namespace
{
constexpr double TwoPi = 6.283185307179586;

/// Triangles of a lattice of columns x rows points, point (i, j) = j * columns + i, where a cell is
/// included.
std::vector<Triangle> Lattice(Index columns, Index rows, bool closeColumns,
  const std::function<bool(Index i, Index j)>& isIncluded)
{
  std::vector<Triangle> triangles;
  for (Index j = 0; j + 1 < rows; ++j)
  {
    for (Index i = 0; i < (closeColumns ? columns : columns - 1); ++i)
    {
      if (isIncluded(i, j))
      {
        const Index next = (i + 1) % columns;
        const Index a = j * columns + i;
        const Index b = j * columns + next;
        triangles.push_back({ a, b, b + columns });
        triangles.push_back({ a, b + columns, a + columns });
      }
    }
  }
  return triangles;
}

bool Always(Index, Index)
{
  return true;
}

std::vector<Vector3> PlanePoints(Index columns, Index rows)
{
  std::vector<Vector3> points;
  for (Index j = 0; j < rows; ++j)
  {
    for (Index i = 0; i < columns; ++i)
    {
      points.emplace_back(i, j, 0.0);
    }
  }
  return points;
}

/// Drops points that no triangle uses.
Surface Compacted(const Surface& surface)
{
  Surface compact;
  std::vector<Index> ids(surface.Points.size(), None);
  for (Triangle t : surface.Triangles)
  {
    for (Index& point : t)
    {
      if (ids[point] == None)
      {
        ids[point] = static_cast<Index>(compact.Points.size());
        compact.Points.push_back(surface.Points[point]);
      }
      point = ids[point];
    }
    compact.Triangles.push_back(t);
  }
  return compact;
}
}

Surface SingleTriangle()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
}

Surface Grid(Index cells)
{
  return { PlanePoints(cells + 1, cells + 1), Lattice(cells + 1, cells + 1, false, Always) };
}

Surface HeightField(Index cells, double amplitude, std::uint64_t seed)
{
  Surface field = Grid(cells);
  Random random(seed);
  for (Vector3& point : field.Points)
  {
    const bool isInside =
      point.x() > 0.0 && point.x() < cells && point.y() > 0.0 && point.y() < cells;
    point.z() = isInside ? random.Between(-amplitude, amplitude) : 0.0;
  }
  return field;
}

Surface HoledPlate(Index cells)
{
  const Index third = cells / 3;
  const auto isIncluded = [=](Index i, Index j)
  { return i < third || i >= 2 * third || j < third || j >= 2 * third; };
  return Compacted(
    { PlanePoints(cells + 1, cells + 1), Lattice(cells + 1, cells + 1, false, isIncluded) });
}

Surface OpenCylinder(Index around, Index rings)
{
  Surface cylinder;
  for (Index j = 0; j <= rings; ++j)
  {
    for (Index i = 0; i < around; ++i)
    {
      const double u = TwoPi * i / around;
      cylinder.Points.emplace_back(5.0 * Cosine(u), 5.0 * Sine(u), j);
    }
  }
  cylinder.Triangles = Lattice(around, rings + 1, true, Always);
  return cylinder;
}

Surface Annulus(Index around, Index rings)
{
  Surface annulus;
  for (Index j = 0; j <= rings; ++j)
  {
    const double r = 10.0 - 6.0 * j / rings;
    for (Index i = 0; i < around; ++i)
    {
      const double u = TwoPi * i / around;
      annulus.Points.emplace_back(r * Cosine(u), r * Sine(u), 0.0);
    }
  }
  annulus.Triangles = Lattice(around, rings + 1, true, Always);
  return annulus;
}

Surface Unwelded(const Surface& surface)
{
  Surface soup;
  for (const Triangle& t : surface.Triangles)
  {
    const auto first = static_cast<Index>(soup.Points.size());
    for (const Index point : t)
    {
      soup.Points.push_back(surface.Points[point]);
    }
    soup.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

Surface Moved(Surface surface, const Vector3& offset)
{
  for (Vector3& point : surface.Points)
  {
    point += offset;
  }
  return surface;
}

Surface Scaled(Surface surface, double factor)
{
  for (Vector3& point : surface.Points)
  {
    point *= factor;
  }
  return surface;
}

Surface TurnedInsideOut(Surface surface)
{
  for (Triangle& t : surface.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return surface;
}

Surface Together(Surface first, const Surface& second)
{
  const auto offset = static_cast<Index>(first.Points.size());
  first.Points.insert(first.Points.end(), second.Points.begin(), second.Points.end());
  for (const Triangle& t : second.Triangles)
  {
    first.Triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
  }
  return first;
}
}
