// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Intersection of triangles compared with tests of all edges in long double; cells and distances
// compared with samples.
#include "BruteForce.h"
#include "Crossings.h"
#include "Proof/Guard/FaceGrid.h"
#include "Proof/Guard/TrianglePair.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Two triangles over seven positions, which have the first `shared` corners in common.
struct Pair
{
  Surface Both;
  TriangleCorners A, B;

  bool Meet(Index shared) const
  {
    const PlaneTriangle a(this->A);
    const PlaneTriangle b(this->B);
    return shared == 0 ? bonedecimate::Meet(a, b)
      : shared == 1    ? MeetBeyondCorner(a, 0, b, 0)
                       : MeetBeyondEdge(a, 2, this->B[2]);
  }
  bool Cross() const
  {
    return testsupport::Cross(this->Both, this->Both.Triangles[0], this->Both.Triangles[1]);
  }
};

class RandomPoints
{
public:
  explicit RandomPoints(unsigned int seed)
    : Random(seed)
  {
  }
  Vector3 Any() { return { this->One(), this->One(), this->One() }; }
  double One() { return this->Uniform(this->Random); }

  template <typename MakePoint>
  Pair AnyPair(Index shared, const MakePoint& makePoint)
  {
    Pair pair;
    for (int i = 0; i < 6; ++i)
    {
      pair.Both.Points.push_back(makePoint());
    }
    const Index second = shared > 0 ? 0 : 3;
    const Index third = shared > 1 ? 1 : 4;
    pair.Both.Triangles = { { 0, 1, 2 }, { second, third, 5 } };
    for (std::size_t i = 0; i < 3; ++i)
    {
      pair.A[i] = pair.Both.Points[pair.Both.Triangles[0][i]];
      pair.B[i] = pair.Both.Points[pair.Both.Triangles[1][i]];
    }
    return pair;
  }

private:
  std::mt19937 Random;
  std::uniform_real_distribution<double> Uniform{ -1.0, 1.0 };
};

/// Whether the second lies on one side of the plane of the first, or in it.
bool LiesOnOneSide(const TriangleCorners& a, const TriangleCorners& b)
{
  const Vector3 normal = (a[1] - a[0]).cross(a[2] - a[0]);
  const auto height = [&](const Vector3& p) { return normal.dot(p - a[0]); };
  return std::min({ height(b[0]), height(b[1]), height(b[2]) }) >= 0.0 ||
    std::max({ height(b[0]), height(b[1]), height(b[2]) }) <= 0.0;
}

/// Whether an edge of a goes through the inside of b, where corners on a lattice let nothing be
/// rounded.
bool EdgeGoesThrough(const TriangleCorners& a, const TriangleCorners& b)
{
  const Vector3 normal = (b[1] - b[0]).cross(b[2] - b[0]);
  bool goesThrough = false;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& p = a[i];
    const Vector3& q = a[(i + 1) % 3];
    const double height = normal.dot(p - b[0]);
    const double depth = normal.dot(b[0] - q);
    const Vector3 where = depth * p + height * q; // height + depth times the point in the plane
    const auto isInside = [&](const Vector3& from, const Vector3& to)
    {
      const double side = normal.dot((to - from).cross(where - (height + depth) * from));
      return height > 0.0 ? side > 0.0 : side < 0.0;
    };
    goesThrough = goesThrough ||
      (height * depth > 0.0 && isInside(b[0], b[1]) && isInside(b[1], b[2]) &&
        isInside(b[2], b[0]));
  }
  return goesThrough;
}

/// Triangles of a surface, which may have common corners.
bool NeighborsMeet(const Surface& surface, Triangle a, Triangle b)
{
  const auto isIn = [](const Triangle& t)
  { return [&t](Index v) { return std::find(t.begin(), t.end(), v) != t.end(); }; };
  const Triangle wholeA = a;
  const auto shared = std::partition(a.begin(), a.end(), isIn(b)) - a.begin();
  std::partition(b.begin(), b.end(), isIn(wholeA));
  const auto triangle = [&surface](const Triangle& t) {
    return PlaneTriangle({ surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]] });
  };
  return shared == 0 ? bonedecimate::Meet(triangle(a), triangle(b))
    : shared == 1    ? MeetBeyondCorner(triangle(a), 0, triangle(b), 0)
                     : MeetBeyondEdge(triangle(a), 2, surface.Points[b[2]]);
}
}

TEST(TrianglePair, MeetsWhereBruteForceFindsThatItDoes)
{
  RandomPoints points(3);
  for (const Index shared : { 0, 1, 2 })
  {
    int met = 0;
    for (int round = 0; round < 20000; ++round)
    {
      const Pair pair = points.AnyPair(shared, [&] { return points.Any(); });
      ASSERT_EQ(pair.Meet(shared), pair.Cross()) << shared << " shared, round " << round;
      met += pair.Cross() ? 1 : 0;
    }
    EXPECT_EQ(met > 1000, shared < 2); // folded flat only by intention
  }
}

TEST(TrianglePair, MeetsWhereBruteForceFindsThatItDoesInOnePlane)
{
  RandomPoints points(5);
  for (const Index shared : { 0, 1, 2 })
  {
    for (int round = 0; round < 5000; ++round)
    {
      const Pair flat =
        points.AnyPair(shared, [&] { return Vector3(points.One(), points.One(), 0.5); });
      ASSERT_EQ(flat.Meet(shared), flat.Cross()) << shared << " shared, round " << round;
    }
  }
}

/// Corners on a small lattice, so that all that is special happens: corners in planes, on edges and
/// on corners, planes in common. Brute force has no rounding there.
TEST(TrianglePair, MeetsWhereBruteForceFindsThatItDoesOnALattice)
{
  RandomPoints points(7);
  const auto makePoint = [&]
  {
    const auto coordinate = [&] { return std::floor(1.5 + 1.5 * points.One()); };
    return Vector3(coordinate(), coordinate(), coordinate());
  };
  for (const Index shared : { 0, 1, 2 })
  {
    int met = 0;
    int touched = 0;
    for (int round = 0; round < 60000; ++round)
    {
      const Pair pair = points.AnyPair(shared, makePoint);
      if (HasArea(pair.A) && HasArea(pair.B))
      {
        ASSERT_EQ(pair.Meet(shared), pair.Cross()) << shared << " shared, round " << round;
        met += pair.Cross() ? 1 : 0;
        touched += pair.Cross() && LiesOnOneSide(pair.A, pair.B) ? 1 : 0;
      }
    }
    EXPECT_GT(met, 500) << shared << " shared";
    EXPECT_GT(touched, 500) << shared << " shared";
  }
}

TEST(TrianglePair, PiercesWhereAnEdgeGoesThroughTheInside)
{
  RandomPoints points(9);
  const auto makePoint = [&]
  {
    const auto coordinate = [&] { return std::floor(2.5 + 2.5 * points.One()); };
    return Vector3(coordinate(), coordinate(), coordinate());
  };
  for (const Index shared : { 0, 1, 2 })
  {
    int pierced = 0;
    int touched = 0;
    for (int round = 0; round < 20000; ++round)
    {
      const Pair pair = points.AnyPair(shared, makePoint);
      const bool expected = EdgeGoesThrough(pair.A, pair.B) || EdgeGoesThrough(pair.B, pair.A);
      ASSERT_EQ(Pierce(PlaneTriangle(pair.A), PlaneTriangle(pair.B)), expected)
        << shared << " shared, round " << round;
      pierced += expected ? 1 : 0;
      touched += pair.Meet(shared) && !expected ? 1 : 0;
    }
    EXPECT_EQ(pierced > 100, shared < 2);
    EXPECT_GT(touched, 100);
  }
}

/// The pair is known on a lattice, and stays what it is in a plane that is not along an axis, where
/// nothing is rounded.
TEST(TrianglePair, DecidesTheSameInEveryPlaneOfALattice)
{
  RandomPoints points(15);
  const std::array<std::array<Vector3, 2>, 4> planes = { { { Vector3(1, 1, 0), Vector3(0, 0, 1) },
    { Vector3(1, 0, 1), Vector3(-1, 1, 0) }, { Vector3(3, 5, 7), Vector3(-2, 11, 1) },
    { Vector3(0, 0.95703125, 1.5), Vector3(1, 0, 0) } } };
  for (const Index shared : { 0, 1, 2 })
  {
    for (int round = 0; round < 5000; ++round)
    {
      const Pair flat = points.AnyPair(shared,
        [&] { return Vector3(std::floor(4.0 * points.One()), std::floor(4.0 * points.One()), 0); });
      for (const auto& [u, v] : planes)
      {
        Pair tilted = flat;
        for (std::size_t i = 0; i < 3; ++i)
        {
          tilted.A[i] = flat.A[i][0] * u + flat.A[i][1] * v;
          tilted.B[i] = flat.B[i][0] * u + flat.B[i][1] * v;
        }
        ASSERT_EQ(tilted.Meet(shared), flat.Meet(shared)) << shared << " shared, round " << round;
      }
    }
  }
}

TEST(TrianglePair, TouchesOrNotByOneBit)
{
  const TriangleCorners floor = { Vector3(0, 0, 0), Vector3(3, 0, 1), Vector3(0, 3, 1) };
  // Above the middle of the floor, in whose plane it lies.
  const Vector3 foot(1, 1, 2.0 / 3.0);
  const double above = std::nextafter(foot[2], 1.0);
  const double below = std::nextafter(foot[2], 0.0);
  const auto meets = [&](double height)
  {
    return bonedecimate::Meet(PlaneTriangle(floor),
      PlaneTriangle({ Vector3(1, 1, height), Vector3(1, 1, 5), Vector3(2, 1, 5) }));
  };
  EXPECT_FALSE(meets(above));
  EXPECT_TRUE(meets(below));
}

TEST(TrianglePair, NeighborsInAFlatGridDoNotMeet)
{
  Surface grid = Grid(4);
  for (const double tilt : { 0.0, 1.0, 0.3 })
  {
    for (Vector3& p : grid.Points)
    {
      p[2] = tilt * (p[0] + p[1]); // 0.3 rounds: not quite in one plane
    }
    for (const Triangle& a : grid.Triangles)
    {
      for (const Triangle& b : grid.Triangles)
      {
        EXPECT_TRUE(a == b || !NeighborsMeet(grid, a, b)) << tilt;
      }
    }
  }
}

TEST(TrianglePair, FoldedFlatOntoItsNeighborItMeetsIt)
{
  const PlaneTriangle a({ Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0.3, 1, 0) });
  EXPECT_TRUE(MeetBeyondEdge(a, 2, Vector3(0.6, 0.5, 0)));
  EXPECT_FALSE(MeetBeyondEdge(a, 2, Vector3(0.6, -0.5, 0)));
  EXPECT_FALSE(MeetBeyondEdge(a, 2, Vector3(0.6, 0.5, 1e-300)));
}

TEST(TrianglePair, DistanceAgreesWithBruteForce)
{
  RandomPoints points(9);
  for (int round = 0; round < 3000; ++round)
  {
    const Pair pair = points.AnyPair(0, [&] { return points.Any(); });
    if (!pair.Cross())
    {
      const auto isFirst = [](const Triangle& t) { return t[0] == 0; };
      const auto isSecond = [](const Triangle& t) { return t[0] == 3; };
      const Connection way = ShortestConnection(pair.A, pair.B);
      const double expected = LeastDistance(pair.Both, isFirst, isSecond);
      EXPECT_NEAR(std::sqrt(way.SquaredLength), expected, 0.02);
      EXPECT_LE(std::sqrt(way.SquaredLength), expected + 1e-12);
    }
  }
}

TEST(TrianglePair, RaysHitWhatTheyGoThrough)
{
  const PlaneTriangle t({ Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0) });
  const auto shoot = [&t](double x, double y, double from, double to) {
    return ShootRay({ x, y, from }, { x, y, to }, t);
  };
  EXPECT_EQ(shoot(0.2, 0.2, -1.0, 9.0), RayResult::Hits);
  EXPECT_EQ(shoot(0.2, 0.2, -1.0, -9.0), RayResult::Misses);
  EXPECT_EQ(shoot(0.8, 0.8, -1.0, 9.0), RayResult::Misses);
  EXPECT_EQ(shoot(0.5, 0.5, -1.0, 9.0), RayResult::Unclear);
  EXPECT_EQ(shoot(0.2, 0.2, 0.0, 9.0), RayResult::Unclear);
  EXPECT_EQ(shoot(0.8, 0.8, 0.0, 9.0), RayResult::Misses);
  EXPECT_EQ(shoot(std::nextafter(0.5, 1.0), 0.5, -1.0, 9.0), RayResult::Misses);
  EXPECT_EQ(shoot(std::nextafter(0.5, 0.0), 0.5, -1.0, 9.0), RayResult::Hits);
}

TEST(FaceGrid, LeavesNoCellOutThatATriangleReachesInto)
{
  const FaceGrid grid(HalfEdgeMesh(Scaled(Icosphere(3, 1.0), 0.5)), 0.0);
  RandomPoints points(13);
  for (int round = 0; round < 2000; ++round)
  {
    const TriangleCorners t = { points.Any(), points.Any(), points.Any() };
    const double reach = 0.2 * (1.0 + points.One());
    std::vector<FaceGrid::CellKey> cells;
    grid.AddCells(t, reach, cells);
    std::sort(cells.begin(), cells.end());
    EXPECT_EQ(std::unique(cells.begin(), cells.end()), cells.end());
    for (int i = 0; i < 20; ++i)
    {
      const double b = 0.5 * (1.0 + points.One());
      const double c = 0.5 * (1.0 + points.One()) * (1.0 - b);
      const Vector3 p = t[0] + b * (t[1] - t[0]) + c * (t[2] - t[0]) +
        reach * points.One() * points.Any().normalized();
      std::vector<FaceGrid::CellKey> own;
      grid.AddCells({ p, p, p }, 0.0, own);
      EXPECT_TRUE(std::any_of(own.begin(), own.end(),
        [&](FaceGrid::CellKey cell)
        { return std::binary_search(cells.begin(), cells.end(), cell); }));
    }
  }
}
