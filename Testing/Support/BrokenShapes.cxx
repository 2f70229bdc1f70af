// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Angles.h"
#include "Random.h"
#include "Shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace bonedecimate::testsupport
{
namespace
{
constexpr double TwoPi = 6.283185307179586;

/// An open cone from a tip at the origin towards z, whose rings are appended to the existing
/// points.
void AddCone(Surface& surface, Index tip, Index around, Index rings, double height)
{
  const auto first = static_cast<Index>(surface.Points.size());
  for (Index j = 1; j <= rings; ++j)
  {
    for (Index i = 0; i < around; ++i)
    {
      const double u = TwoPi * i / around;
      surface.Points.emplace_back(j * Cosine(u), j * Sine(u), height * j);
    }
  }
  const bool isUp = height > 0.0;
  const auto add = [&](Index a, Index b, Index c) {
    surface.Triangles.push_back(isUp ? Triangle{ a, c, b } : Triangle{ a, b, c });
  };
  for (Index i = 0; i < around; ++i)
  {
    const Index next = (i + 1) % around;
    add(tip, first + i, first + next);
    for (Index j = 0; j + 1 < rings; ++j)
    {
      const Index a = first + j * around + i;
      const Index b = first + j * around + next;
      add(a, a + around, b + around);
      add(a, b + around, b);
    }
  }
}

/// A fan over the last ring of an open cone.
void AddLid(Surface& surface, Index around, double height)
{
  const auto middle = static_cast<Index>(surface.Points.size());
  const Index first = middle - around;
  surface.Points.emplace_back(0.0, 0.0, height);
  for (Index i = 0; i < around; ++i)
  {
    const Index next = first + (i + 1) % around;
    surface.Triangles.push_back(
      height > 0.0 ? Triangle{ middle, first + i, next } : Triangle{ middle, next, first + i });
  }
}

using Cell = std::array<Index, 3>;

/// Squares between cells of a lattice, as two triangles each.
class CellWalls
{
public:
  /// Between a cell and the one before it along an axis.
  void Add(const Cell& cell, std::size_t axis, bool isTurned)
  {
    const std::size_t u = (axis + (isTurned ? 2 : 1)) % 3;
    const std::size_t v = (axis + (isTurned ? 1 : 2)) % 3;
    std::array<Index, 4> square{};
    for (std::size_t k = 0; k < 4; ++k)
    {
      Cell corner = cell;
      corner[u] += k == 1 || k == 2 ? 1 : 0;
      corner[v] += k > 1 ? 1 : 0;
      square[k] = this->PointAt(corner);
    }
    this->Walls.Triangles.push_back({ square[0], square[1], square[2] });
    this->Walls.Triangles.push_back({ square[0], square[2], square[3] });
  }

  Surface Walls;

private:
  Index PointAt(const Cell& corner)
  {
    const auto found = this->Points.emplace(corner, static_cast<Index>(this->Points.size()));
    if (found.second)
    {
      this->Walls.Points.emplace_back(corner[0], corner[1], corner[2]);
    }
    return found.first->second;
  }

  std::map<Cell, Index> Points;
};
}

Surface Smoothed(Surface surface, int times)
{
  for (; times > 0; --times)
  {
    std::vector<Vector3> sums(surface.Points.size(), Vector3::Zero());
    std::vector<double> counts(surface.Points.size(), 0.0);
    for (const Triangle& t : surface.Triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        sums[t[k]] += surface.Points[t[(k + 1) % 3]] + surface.Points[t[(k + 2) % 3]];
        counts[t[k]] += 2.0;
      }
    }
    for (std::size_t p = 0; p < sums.size(); ++p)
    {
      surface.Points[p] = 0.5 * surface.Points[p] + 0.5 / counts[p] * sums[p];
    }
  }
  return surface;
}

Surface PinchedVertex(Index around, Index rings)
{
  Surface cones;
  cones.Points.emplace_back(0.0, 0.0, 0.0);
  AddCone(cones, 0, around, rings, 1.0);
  AddCone(cones, 0, around, rings, -1.0);
  return cones;
}

Surface PinchedSolids(Index around)
{
  Surface cones;
  cones.Points.emplace_back(0.0, 0.0, 0.0);
  AddCone(cones, 0, around, 2, 1.0);
  AddLid(cones, around, 2.0);
  AddCone(cones, 0, around, 2, -1.0);
  AddLid(cones, around, -2.0);
  return cones;
}

Surface TetrahedronChain(Index count)
{
  // The shared corners lie on the x axis, one edge length apart; the free edge of each crosses at
  // right angles.
  const double h = std::sqrt(0.5);
  Surface chain;
  chain.Points.emplace_back(0.0, 0.0, 0.0);
  for (Index i = 0; i < count; ++i)
  {
    const Index left = 3 * i;
    const double middle = i + 0.5;
    chain.Points.insert(
      chain.Points.end(), { { middle, h, 0.5 }, { middle, h, -0.5 }, { i + 1.0, 0.0, 0.0 } });
    const std::array<Index, 4> c = { left, left + 1, left + 2, left + 3 };
    chain.Triangles.insert(chain.Triangles.end(),
      { { c[0], c[1], c[2] }, { c[0], c[3], c[1] }, { c[0], c[2], c[3] }, { c[1], c[3], c[2] } });
  }
  return chain;
}

Surface ThreeLeavedBook(Index cells)
{
  Surface book;
  for (Index j = 0; j <= cells; ++j)
  {
    book.Points.emplace_back(0.0, j, 0.0);
  }
  for (int leaf = 0; leaf < 3; ++leaf)
  {
    const double u = TwoPi * leaf / 3.0;
    const auto first = static_cast<Index>(book.Points.size());
    const auto point = [&](Index i, Index j)
    { return i == 0 ? j : first + (i - 1) * (cells + 1) + j; };
    for (Index i = 1; i <= cells; ++i)
    {
      for (Index j = 0; j <= cells; ++j)
      {
        book.Points.emplace_back(i * Cosine(u), j, i * Sine(u));
      }
    }
    for (Index i = 0; i < cells; ++i)
    {
      for (Index j = 0; j < cells; ++j)
      {
        book.Triangles.push_back({ point(i, j), point(i + 1, j), point(i + 1, j + 1) });
        book.Triangles.push_back({ point(i, j), point(i + 1, j + 1), point(i, j + 1) });
      }
    }
  }
  return book;
}

Surface MoebiusStrip(Index around, Index across)
{
  Surface strip;
  for (Index i = 0; i < around; ++i)
  {
    const double u = TwoPi * i / around;
    for (Index j = 0; j <= across; ++j)
    {
      const double v = 4.0 * j / across - 2.0;
      const double r = 10.0 + v * Cosine(0.5 * u);
      strip.Points.emplace_back(r * Cosine(u), r * Sine(u), v * Sine(0.5 * u));
    }
  }
  const auto point = [&](Index i, Index j)
  { return i < around ? i * (across + 1) + j : across - j; };
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      strip.Triangles.push_back({ point(i, j), point(i + 1, j), point(i + 1, j + 1) });
      strip.Triangles.push_back({ point(i, j), point(i + 1, j + 1), point(i, j + 1) });
    }
  }
  return strip;
}

Surface InconsistentGrid(Index cells)
{
  Surface grid = Grid(cells);
  Triangle& middle = grid.Triangles[cells * cells + cells];
  std::swap(middle[1], middle[2]);
  return grid;
}

Surface DuplicateTriangles(int levels, Index copies)
{
  Surface sphere = Icosphere(levels, 5.0);
  const std::vector<Triangle> first(sphere.Triangles.begin(), sphere.Triangles.begin() + copies);
  sphere.Triangles.insert(sphere.Triangles.end(), first.begin(), first.end());
  return sphere;
}

Surface HalvedBall(Index radius)
{
  const auto cellAt = [radius](const Cell& c)
  {
    const Vector3 middle(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
    return middle.squaredNorm() > radius * radius ? 0 : c[0] < 0 ? 1 : 2;
  };
  CellWalls walls;
  const Index side = 2 * radius + 1;
  for (Index i = 0; i < 3 * side * side * side; ++i)
  {
    const auto axis = static_cast<std::size_t>(i % 3);
    const Cell cell = { i / 3 % side - radius, i / 3 / side % side - radius,
      i / 3 / side / side - radius };
    Cell below = cell;
    --below[axis];
    if (cellAt(cell) != cellAt(below))
    {
      walls.Add(cell, axis, cellAt(below) == 0);
    }
  }
  return Smoothed(walls.Walls, 3);
}

Surface RandomSoup(Index points, Index triangles, std::uint64_t seed)
{
  Random random(seed);
  Surface soup;
  for (Index i = 0; i < points; ++i)
  {
    soup.Points.push_back(random.InCube(5.0));
  }
  while (static_cast<Index>(soup.Triangles.size()) < triangles)
  {
    const Triangle t = { random.Below(points), random.Below(points), random.Below(points) };
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    {
      soup.Triangles.push_back(t);
    }
  }
  return soup;
}

std::vector<NamedSurface> ClosedShapes()
{
  return { { "Tetrahedron", Tetrahedron() }, { "Cube", Cube(4) },
    { "Icosphere", Icosphere(3, 5.0) }, { "BumpySphere", BumpySphere(3, 5.0, 0.1, 7) },
    { "NoisySphere", BumpySphere(2, 5.0, 0.4, 8) }, { "Torus", Torus(24, 12) },
    { "TunnelBlock", TunnelBlock(6) }, { "FlatPlate", FlatPlate(8) },
    { "NestedSpheres", NestedSpheres(2) }, { "Needles", Needles(48) },
    { "ManyComponents", ManyComponents(12) }, { "Envelope", Envelope() },
    { "EnvelopeBesideSphere", Together(Envelope(), Moved(Icosphere(2, 5.0), { 20, 0, 0 })) },
    { "Box", Scaled(Cube(6), 3.5) }, { "Prism", Prism(5, 3, 4) },
    { "CappedCylinder", CappedCylinder(16, 4) }, { "VoxelEllipsoid", VoxelEllipsoid() },
    { "HalfOfLabels", LabeledPart(1) }, { "CoreOfLabels", LabeledPart(3) },
    { "NearSpheres", NearSpheres(1, 0.001) } };
}

std::vector<NamedSurface> OpenShapes()
{
  return { { "SingleTriangle", SingleTriangle() }, { "Grid", Grid(10) },
    { "HeightField", HeightField(12, 0.5, 3) }, { "HoledPlate", HoledPlate(9) },
    { "OpenCylinder", OpenCylinder(16, 8) }, { "Annulus", Annulus(24, 5) },
    { "UnweldedCube", Unwelded(Cube(2)) },
    { "PatchBesideTorus", Together(Grid(5), Moved(Torus(12, 8), { 30, 0, 0 })) } };
}

std::vector<NamedSurface> BrokenShapes()
{
  return { { "PinchedVertex", PinchedVertex(12, 6) }, { "PinchedSolids", PinchedSolids(12) },
    { "TetrahedronChain", TetrahedronChain(5) }, { "ThreeLeavedBook", ThreeLeavedBook(6) },
    { "MoebiusStrip", MoebiusStrip(30, 5) }, { "InconsistentGrid", InconsistentGrid(8) },
    { "DuplicateTriangles", DuplicateTriangles(2, 20) }, { "HalvedBall", HalvedBall(5) },
    { "SparseSoup", RandomSoup(300, 100, 11) }, { "DenseSoup", RandomSoup(40, 200, 12) } };
}

std::vector<NamedSurface> AllShapes()
{
  std::vector<NamedSurface> all = ClosedShapes();
  for (const auto& list : { OpenShapes(), BrokenShapes() })
  {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}
}
