// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Geometry/BoundingTree.h"
#include "Random.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// The least triangle of the least distance as the core's own arithmetic sees it: ties must be
/// broken by id.
Index LeastTriangle(const Surface& surface, const Vector3& p)
{
  Index best = None;
  double least = 0.0;
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    const Triangle& t = surface.Triangles[i];
    const double squared =
      NearestOnTriangle(p, surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]])
        .SquaredDistance;
    if (best == None || squared < least)
    {
      best = static_cast<Index>(i);
      least = squared;
    }
  }
  return best;
}

void ExpectNearest(
  const Surface& surface, const BoundingTree& tree, const Vector3& p, Random& random)
{
  const BoundingTree::Nearest nearest = tree.FindNearest(p);
  const double size = 1.0 + p.norm();
  EXPECT_NEAR(
    std::sqrt(nearest.Point.SquaredDistance), BruteNearest(surface, p).Distance, 1e-12 * size);
  EXPECT_EQ(nearest.Triangle, LeastTriangle(surface, p));
  EXPECT_EQ(tree.FindNearestPoint(p), BruteNearestPoint(surface, p));
  const Index hint = random.Below(static_cast<Index>(surface.Triangles.size()));
  EXPECT_EQ(tree.FindNearest(p, hint).Triangle, nearest.Triangle) << "hint " << hint;
  EXPECT_EQ(tree.FindNearest(p, hint).Point.SquaredDistance, nearest.Point.SquaredDistance);
  EXPECT_EQ(tree.FindNearestPoint(p, hint), tree.FindNearestPoint(p)) << "hint " << hint;
}
}

TEST(BoundingTree, WithoutTrianglesNothingIsNearest)
{
  const BoundingTree tree(Surface{});
  EXPECT_EQ(tree.FindNearest({ 1, 2, 3 }).Triangle, None);
  EXPECT_EQ(tree.FindNearestPoint({ 1, 2, 3 }), None);
}

TEST(BoundingTree, NearestOnAllShapesAgreesWithBruteForce)
{
  Random random(6);
  for (const NamedSurface& shape : AllShapes())
  {
    SCOPED_TRACE(shape.Name);
    const BoundingTree tree(shape.Surface);
    for (int i = 0; i < 30; ++i)
    {
      ExpectNearest(shape.Surface, tree, random.InCube(15), random);
    }
  }
}

TEST(BoundingTree, NearestOfCornersAndMiddlesBreaksTiesByTheLeastId)
{
  Random random(7);
  const Surface surface = Cube(6);
  const BoundingTree tree(surface);
  for (const Vector3& corner : surface.Points)
  {
    ExpectNearest(surface, tree, corner, random);
  }
  ExpectNearest(surface, tree, { 0.5, 0.5, 0.5 }, random);
}

TEST(BoundingTree, EqualTrianglesGiveTheFirst)
{
  Surface stack = SingleTriangle();
  for (int i = 0; i < 40; ++i)
  {
    stack.Triangles.push_back(stack.Triangles.front());
  }
  const BoundingTree tree(stack);
  for (Index hint = 0; hint < 41; ++hint)
  {
    EXPECT_EQ(tree.FindNearest({ 0.2, 0.2, 1.0 }, hint).Triangle, 0);
  }
}

TEST(BoundingTree, PointsThatNoTriangleUsesAreNeverNearest)
{
  Surface surface = SingleTriangle();
  surface.Points.emplace_back(9.0, 9.0, 9.0);
  EXPECT_NE(BoundingTree(surface).FindNearestPoint({ 9, 9, 9 }), 3);
}

TEST(BoundingTree, AcceptsDegenerateTriangles)
{
  Random random(8);
  Surface surface;
  for (Index i = 0; i < 200; ++i)
  {
    const Vector3 a = random.InCube(5);
    const Vector3 along = random.InCube(1);
    surface.Points.insert(surface.Points.end(), { a, a + along, i % 2 == 0 ? a : a + 2.0 * along });
    surface.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  const BoundingTree tree(surface);
  for (int i = 0; i < 100; ++i)
  {
    ExpectNearest(surface, tree, random.InCube(8), random);
  }
}

TEST(BoundingTree, FarPointsAgreeWithBruteForce)
{
  Random random(9);
  const Surface surface = BumpySphere(2, 5.0, 0.2, 4);
  const BoundingTree tree(surface);
  for (int i = 0; i < 50; ++i)
  {
    const Vector3 p = 1e5 * random.InCube(1);
    const BoundingTree::Nearest nearest = tree.FindNearest(p);
    EXPECT_NEAR(std::sqrt(nearest.Point.SquaredDistance), BruteNearest(surface, p).Distance,
      1e-12 * p.norm());
    EXPECT_EQ(nearest.Triangle, LeastTriangle(surface, p));
  }
}

namespace
{
/// Whether a ray of that length meets a triangle well inside of it.
bool Meets(const Surface& surface, const Triangle& c, const Vector3& from, const Vector3& to)
{
  const auto volume = [](const Vector3& a, const Vector3& b, const Vector3& p, const Vector3& q)
  { return (b - a).cross(p - a).dot(q - a); };
  const auto& [a, b, d] =
    std::array<Vector3, 3>{ surface.Points[c[0]], surface.Points[c[1]], surface.Points[c[2]] };
  const double sides[] = { volume(from, to, a, b), volume(from, to, b, d), volume(from, to, d, a) };
  const bool isBetween = volume(a, b, d, from) * volume(a, b, d, to) < 0.0;
  const bool isThrough = (sides[0] > 0.0 && sides[1] > 0.0 && sides[2] > 0.0) ||
    (sides[0] < 0.0 && sides[1] < 0.0 && sides[2] < 0.0);
  return isBetween && isThrough;
}
}

TEST(BoundingTree, VisitsEveryTriangleThatARayMeets)
{
  Random random(5);
  const auto coordinate = [&] { return 0.1 * (random.Below(401) - 200); };
  for (const NamedSurface& shape : AllShapes())
  {
    const BoundingTree tree(shape.Surface);
    for (int i = 0; i < 40; ++i)
    {
      const Vector3 from(coordinate(), coordinate(), coordinate());
      Vector3 to(coordinate(), coordinate(), coordinate());
      to[i % 3] = i % 2 == 0 ? from[i % 3] : to[i % 3]; // also along planes of the axes
      const double length = (to - from).norm();
      if (length == 0.0)
      {
        continue;
      }
      std::vector<char> isVisited(shape.Surface.Triangles.size(), 0);
      tree.VisitAlong(from, (to - from) / length, length,
        [&](Index triangle) { isVisited[static_cast<std::size_t>(triangle)] = 1; });
      for (std::size_t t = 0; t < isVisited.size(); ++t)
      {
        if (Meets(shape.Surface, shape.Surface.Triangles[t], from, to))
        {
          EXPECT_EQ(isVisited[t], 1) << shape.Name << " " << t;
        }
      }
    }
  }
}

TEST(BoundingTree, VisitsFewTrianglesAlongARay)
{
  const Surface sphere = Icosphere(5, 10.0);
  const BoundingTree tree(sphere);
  const auto count = [&](const Vector3& from, const Vector3& direction, double length)
  {
    int visits = 0;
    tree.VisitAlong(from, direction, length, [&](Index) { ++visits; });
    return visits;
  };
  EXPECT_GE(count({ 0.1, 0.2, 0.0 }, { 0, 0, 1 }, 100.0), 1);
  EXPECT_LE(count({ 0.1, 0.2, 0.0 }, { 0, 0, 1 }, 100.0), 40);
  EXPECT_EQ(count({ 0.1, 0.2, 0.0 }, { 0, 0, 1 }, 5.0), 0) << "too short";
  EXPECT_EQ(count({ 0.1, 0.2, 11.0 }, { 0, 0, 1 }, 100.0), 0) << "the other way";
}
