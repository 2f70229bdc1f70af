// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Victims.h"

#include "Shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace bonedecimate::testsupport
{
namespace
{
constexpr Index LargestCut = 1500; // triangles

/// Two walls that face each other across a narrow gap, and a wavy surface above them.
Surface Walls(Random& random)
{
  const Index cells = 5 + random.Below(12);
  const Surface wall = HeightField(cells, random.Between(0.0, 0.6), 1 + random.Below(1000));
  const double gap = random.Between(0.02, 1.0);
  Surface walls = Together(wall, Moved(TurnedInsideOut(wall), { 0.0, 0.0, gap }));
  return random.Below(2) == 0 ? walls : Together(walls, Moved(wall, { 0.3, 0.2, 3.0 * gap }));
}

Surface WavingGridOf(Random& random, Index cells)
{
  Surface surface = Grid(cells);
  const double height = random.Between(0.0, 2.0);
  const double alongX = random.Between(0.05, 1.5);
  const double alongY = random.Between(0.05, 1.5);
  for (Vector3& p : surface.Points)
  {
    p[2] += height * std::sin(alongX * p[0]) * std::cos(alongY * p[1]);
  }
  return surface;
}

Surface WavingGrid(Random& random)
{
  return WavingGridOf(random, 5 + random.Below(20));
}

Surface Bumps(Random& random)
{
  return BumpySphere(1 + random.Below(3), 10.0, random.Between(0.0, 0.4),
    static_cast<std::uint64_t>(random.Below(1000)));
}

/// A shell: the inner wall follows the outer one.
Surface Shell(Random& random)
{
  const Surface outer = Bumps(random);
  return Together(outer, TurnedInsideOut(Scaled(outer, random.Between(0.8, 0.999))));
}

/// Flat parts: a prism, a box turned anywhere or not at all.
Surface FlatSides(Random& random)
{
  Surface surface = random.Below(2) == 0
    ? Prism(3 + random.Below(9), 1 + random.Below(5), 1 + random.Below(6))
    : Cube(1 + random.Below(9));
  if (random.Below(2) == 0)
  {
    const Vector3 x = (Vector3(1.0, 0.0, 0.0) + random.InCube(0.5)).normalized();
    const Vector3 y = x.cross(random.InCube(1.0)).normalized();
    const Vector3 z = x.cross(y);
    for (Vector3& p : surface.Points)
    {
      p = p[0] * x + p[1] * y + p[2] * z;
    }
  }
  return surface;
}

/// One label of a label map: an ellipsoid cut by a plane, with wrong voxels here and there.
Surface LabelMapPart(Random& random)
{
  const std::array<Index, 3> size = { 3 + random.Below(6), 3 + random.Below(6),
    3 + random.Below(5) };
  const Vector3 middle = 0.5 * Vector3(size[0] - 1, size[1] - 1, size[2] - 1);
  const Vector3 axes = middle + random.InCube(0.5);
  const Vector3 cut = random.InCube(1.0);
  const double noise = random.Below(2) == 0 ? 0.0 : random.Between(0.0, 0.2);
  std::vector<int> labels;
  for (Index i = 0; i < size[0] * size[1] * size[2]; ++i)
  {
    const Vector3 at = Vector3(i % size[0], i / size[0] % size[1], i / size[0] / size[1]) - middle;
    const bool isInside = (at.cwiseQuotient(axes)).squaredNorm() < 1.0;
    const bool isWrong = random.Uniform() < noise;
    labels.push_back(isInside == isWrong ? 0 : cut.dot(at) < 0.5 ? 1 : 2);
  }
  const Vector3 spacing(1.0, 1.0, random.Below(2) == 0 ? 1.0 : random.Between(0.5, 3.0));
  const auto labelOf = [&](const std::array<Index, 3>& voxel) {
    return labels[static_cast<std::size_t>((voxel[2] * size[1] + voxel[1]) * size[0] + voxel[0])];
  };
  const Surface surface = LabelSurface(size, spacing, labelOf, 1);
  return surface.Triangles.empty() ? Cube(3) : surface;
}

Surface NearWalls(Random& random)
{
  return NearSpheres(1 + random.Below(3), std::pow(10.0, random.Between(-5.0, -1.0)));
}

/// A bumpy ball and specks so near to it, inside or outside, that it could jump over them.
Surface Specks(Random& random)
{
  const Surface ball = BumpySphere(2 + random.Below(2), 10.0, random.Between(0.0, 0.3),
    static_cast<std::uint64_t>(random.Below(1000)));
  Surface all = ball;
  for (Index left = 1 + random.Below(6); left > 0; --left)
  {
    const Vector3& near =
      ball.Points[static_cast<std::size_t>(random.Below(static_cast<Index>(ball.Points.size())))];
    const double depth = std::pow(10.0, random.Between(-2.5, -0.5)); // of the radius
    const double size = 10.0 * depth * random.Between(0.05, 0.5);
    const double side = random.Below(2) == 0 ? 1.0 : -1.0;
    all = Together(all,
      Moved(
        Scaled(Tetrahedron(), size), near * (1.0 + side * depth) - Vector3::Constant(0.25 * size)));
  }
  return all;
}

/// A grid cut along a part of a row, far less than an edge apart: in single precision the cut may
/// close.
Surface Slit(Random& random)
{
  const Index cells = 6 + 2 * random.Below(6);
  Surface surface = WavingGridOf(random, cells);
  const double gap = std::pow(10.0, random.Between(-12.0, -2.0));
  const Index length = 1 + random.Below(cells - 2);
  const Index row = cells / 2;
  for (Index i = 0; i < length; ++i)
  {
    // The triangles above the row get points of their own.
    const Index point = row * (cells + 1) + i;
    const Index copy = static_cast<Index>(surface.Points.size());
    surface.Points.push_back(
      surface.Points[static_cast<std::size_t>(point)] + Vector3(0.0, gap, 0.0));
    for (Triangle& t : surface.Triangles)
    {
      const bool isAbove = std::any_of(t.begin(), t.end(),
        [&](Index corner) { return corner < copy - i && corner >= (row + 1) * (cells + 1); });
      std::replace(t.begin(), t.end(), point, isAbove ? copy : point);
    }
  }
  return surface;
}

/// One of the shapes of the other tests.
Surface KnownShape(Random& random)
{
  static const std::vector<NamedSurface> shapes = AllShapes();
  return shapes[static_cast<std::size_t>(random.Below(static_cast<Index>(shapes.size())))].Surface;
}

/// The selected triangles with the points that they use.
Surface Part(const Surface& surface, const std::function<bool(const Triangle&)>& isTaken)
{
  Surface part;
  std::vector<Index> number(surface.Points.size(), None);
  for (const Triangle& corners : surface.Triangles)
  {
    if (!isTaken(corners))
    {
      continue;
    }
    Triangle renamed = {};
    for (std::size_t k = 0; k < 3; ++k)
    {
      Index& id = number[static_cast<std::size_t>(corners[k])];
      if (id == None)
      {
        id = static_cast<Index>(part.Points.size());
        part.Points.push_back(surface.Points[static_cast<std::size_t>(corners[k])]);
      }
      renamed[k] = id;
    }
    part.Triangles.push_back(renamed);
  }
  return part;
}

/// The part in a ball around a point, as large as the limit of triangles allows.
Surface CutOut(Random& random, const Surface& large)
{
  const Index middle = random.Below(static_cast<Index>(large.Points.size()));
  const Vector3 center = large.Points[static_cast<std::size_t>(middle)];
  const auto distance2 = [&](const Triangle& corners)
  { return (large.Points[static_cast<std::size_t>(corners[0])] - center).squaredNorm(); };
  std::vector<double> all;
  all.reserve(large.Triangles.size());
  std::transform(
    large.Triangles.begin(), large.Triangles.end(), std::back_inserter(all), distance2);
  const auto wanted = std::min<std::size_t>(
    all.size() - 1, static_cast<std::size_t>(100 + random.Below(LargestCut - 100)));
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(wanted), all.end());
  const double radius2 = all[wanted];
  return Part(large, [&](const Triangle& corners) { return distance2(corners) <= radius2; });
}

/// Points moved by up to a fraction of an edge, triangles removed.
Surface Damaged(Random& random, Surface surface)
{
  if (random.Below(3) == 0)
  {
    const double most = random.Between(0.0, 0.5) * MeanEdge(surface);
    for (Vector3& p : surface.Points)
    {
      p += random.InCube(most);
    }
  }
  if (random.Below(4) == 0)
  {
    const double fraction = random.Between(0.0, 0.1);
    surface = Part(surface, [&](const Triangle&) { return random.Uniform() >= fraction; });
  }
  return surface;
}
}

double MeanEdge(const Surface& surface)
{
  double sum = 0.0;
  for (const Triangle& corners : surface.Triangles)
  {
    sum += (surface.Points[static_cast<std::size_t>(corners[0])] -
      surface.Points[static_cast<std::size_t>(corners[1])])
             .norm();
  }
  return sum / std::max<double>(1.0, static_cast<double>(surface.Triangles.size()));
}

//------------------------------------------------------------------------------
double DrawEdgeLength(Random& random, const Surface& surface)
{
  return random.Below(4) == 0 ? MeanEdge(surface) * std::pow(10.0, random.Between(-0.4, 0.8)) : 0.0;
}

//------------------------------------------------------------------------------
std::vector<double> AnyMap(Random& random, const Surface& surface, double error)
{
  const auto anyPoint = [&]
  {
    return surface
      .Points[static_cast<std::size_t>(random.Below(static_cast<Index>(surface.Points.size())))];
  };
  const Vector3 center = anyPoint();
  const Vector3 free = anyPoint();
  const double radius = MeanEdge(surface) * random.Between(0.0, 6.0);
  const double slope = random.Between(0.0, 0.5);
  std::vector<double> tolerances;
  for (const Vector3& p : surface.Points)
  {
    const double distance = std::max(0.0, (p - center).norm() - radius);
    tolerances.push_back(
      (p - free).norm() < radius ? -1.0 : std::min(2.0 * error, slope * distance));
  }
  return tolerances;
}

//------------------------------------------------------------------------------
Surface AnyVictim(Random& random, const std::vector<Surface>& large)
{
  static const std::array<Surface (*)(Random&), 10> makers = { Walls, WavingGrid, Bumps, Shell,
    KnownShape, FlatSides, LabelMapPart, NearWalls, Specks, Slit };
  const bool cuts = !large.empty() && random.Below(2) == 0;
  Surface surface = cuts
    ? CutOut(
        random, large[static_cast<std::size_t>(random.Below(static_cast<Index>(large.size())))])
    : makers[static_cast<std::size_t>(random.Below(static_cast<Index>(makers.size())))](random);
  surface = Damaged(random, std::move(surface));
  if (random.Below(3) == 0)
  {
    surface = Scaled(surface, std::pow(10.0, random.Between(-3.0, 3.0)));
  }
  if (random.Below(3) == 0)
  {
    surface = Moved(surface, random.InCube(std::pow(10.0, random.Between(0.0, 4.0))));
  }
  return surface;
}
}
