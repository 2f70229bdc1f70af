// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Angles.h"
#include "Random.h"
#include "Shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace bonedecimate::testsupport
{
namespace
{
constexpr double TwoPi = 6.283185307179586;

using Cell = std::array<Index, 3>;
using IsSolid = std::function<bool(const Cell& cell)>;

/// The sides between solid cells and the rest, two triangles each, seen from outside.
class BlockSurface
{
public:
  void AddCell(const Cell& cell, const IsSolid& isSolid)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const Index step : { -1, 1 })
      {
        Cell neighbor = cell;
        neighbor[axis] += step;
        if (!isSolid(neighbor))
        {
          this->AddSide(cell, axis, step > 0);
        }
      }
    }
  }

  Surface Built;

private:
  void AddSide(const Cell& cell, std::size_t axis, bool upper)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    std::array<Index, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      Cell corner = cell;
      corner[axis] += upper ? 1 : 0;
      corner[u] += i == 1 || i == 2 ? 1 : 0;
      corner[v] += i >= 2 ? 1 : 0;
      corners[i] = this->PointAt(corner);
    }
    if (!upper)
    {
      std::swap(corners[1], corners[3]);
    }
    this->Built.Triangles.push_back({ corners[0], corners[1], corners[2] });
    this->Built.Triangles.push_back({ corners[0], corners[2], corners[3] });
  }

  Index PointAt(const Cell& corner)
  {
    const auto next = static_cast<Index>(this->Built.Points.size());
    const auto [entry, isNew] = this->Ids.emplace(corner, next);
    if (isNew)
    {
      this->Built.Points.emplace_back(corner[0], corner[1], corner[2]);
    }
    return entry->second;
  }

  std::map<Cell, Index> Ids;
};

Surface Block(const Cell& size, const IsSolid& isSolidInside)
{
  const IsSolid isSolid = [&](const Cell& cell)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (cell[i] < 0 || cell[i] >= size[i])
      {
        return false;
      }
    }
    return isSolidInside(cell);
  };
  BlockSurface block;
  for (Index x = 0; x < size[0]; ++x)
  {
    for (Index y = 0; y < size[1]; ++y)
    {
      for (Index z = 0; z < size[2]; ++z)
      {
        if (isSolid({ x, y, z }))
        {
          block.AddCell({ x, y, z }, isSolid);
        }
      }
    }
  }
  return block.Built;
}

Surface Icosahedron()
{
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  Surface ico;
  ico.Points = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g },
    { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } };
  ico.Triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  return ico;
}

/// Each triangle in four.
Surface Subdivided(const Surface& coarse)
{
  Surface fine;
  fine.Points = coarse.Points;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b)
  {
    const auto next = static_cast<Index>(fine.Points.size());
    const auto [entry, isNew] = middles.emplace(std::minmax(a, b), next);
    if (isNew)
    {
      fine.Points.push_back(0.5 * (coarse.Points[a] + coarse.Points[b]));
    }
    return entry->second;
  };
  for (const auto& [a, b, c] : coarse.Triangles)
  {
    const Index ab = middle(a, b);
    const Index bc = middle(b, c);
    const Index ca = middle(c, a);
    fine.Triangles.insert(
      fine.Triangles.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
  }
  return fine;
}
}

Surface Tetrahedron()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } } };
}

Surface Cube(Index cells)
{
  return Scaled(Block({ cells, cells, cells }, [](const Cell&) { return true; }), 1.0 / cells);
}

Surface FlatPlate(Index cells)
{
  return Block({ cells, cells, 1 }, [](const Cell&) { return true; });
}

Surface TunnelBlock(Index cells)
{
  const Index low = cells / 3;
  const Index high = cells - low;
  return Block({ cells, cells, 3 },
    [=](const Cell& cell)
    { return cell[0] < low || cell[0] >= high || cell[1] < low || cell[1] >= high; });
}

Surface DrilledPlate()
{
  return Block({ 18, 9, 3 },
    [](const Cell& cell)
    {
      const auto isIn = [&cell](Index low, Index width)
      { return cell[0] >= low && cell[0] < low + width && cell[1] >= 3 && cell[1] < 3 + width; };
      return !isIn(3, 1) && !isIn(7, 2) && !isIn(12, 3);
    });
}

Surface Icosphere(int levels, double radius)
{
  Surface sphere = Icosahedron();
  for (int level = 0; level < levels; ++level)
  {
    sphere = Subdivided(sphere);
  }
  for (Vector3& point : sphere.Points)
  {
    point = radius * point.normalized();
  }
  return sphere;
}

Surface BumpySphere(int levels, double radius, double amplitude, std::uint64_t seed)
{
  Surface sphere = Icosphere(levels, radius);
  Random random(seed);
  for (Vector3& point : sphere.Points)
  {
    point *= 1.0 + random.Between(-amplitude, amplitude);
  }
  return sphere;
}

Surface Torus(Index around, Index across)
{
  Surface torus;
  for (Index i = 0; i < around; ++i)
  {
    const double u = TwoPi * i / around;
    for (Index j = 0; j < across; ++j)
    {
      const double v = TwoPi * j / across;
      const double r = 10.0 + 3.0 * Cosine(v);
      torus.Points.emplace_back(r * Cosine(u), r * Sine(u), 3.0 * Sine(v));
    }
  }
  for (Index i = 0; i < around; ++i)
  {
    const Index next = (i + 1) % around;
    for (Index j = 0; j < across; ++j)
    {
      const Index up = (j + 1) % across;
      const Index a = i * across + j;
      const Index b = next * across + j;
      const Index c = next * across + up;
      const Index d = i * across + up;
      torus.Triangles.push_back({ a, b, c });
      torus.Triangles.push_back({ a, c, d });
    }
  }
  return torus;
}

Surface NestedSpheres(int levels)
{
  return Together(Icosphere(levels, 10.0), TurnedInsideOut(Icosphere(levels, 7.0)));
}

Surface Needles(Index sides)
{
  Surface cone;
  cone.Points = { { 0, 0, 100 }, { 0, 0, 0 } };
  for (Index i = 0; i < sides; ++i)
  {
    const double u = TwoPi * i / sides;
    cone.Points.emplace_back(0.005 * Cosine(u), 0.005 * Sine(u), 0.0);
  }
  for (Index i = 0; i < sides; ++i)
  {
    const Index next = (i + 1) % sides;
    cone.Triangles.push_back({ 0, 2 + i, 2 + next });
    cone.Triangles.push_back({ 1, 2 + next, 2 + i });
  }
  return cone;
}

Surface ManyComponents(Index count)
{
  Surface all;
  for (Index i = 0; i < count; ++i)
  {
    const Surface part = i % 2 == 0 ? Tetrahedron() : Icosphere(1, 1.0);
    all = Together(std::move(all), Moved(part, { 4.0 * i, 0, 0 }));
  }
  return all;
}

Surface Envelope()
{
  return { { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 2, 1, 0 } } };
}
}
