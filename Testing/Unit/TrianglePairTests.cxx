// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Whether triangles meet, held against all edges tried in long double; cells and distances held against samples.
#include "BruteForce.h"
#include "Clearance/FaceGrid.h"
#include "Clearance/TrianglePair.h"
#include "Crossings.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Two triangles over seven places, which have the first `shared` corners in common.
struct Pair
{
  Surface Both;
  TriangleCorners A, B;

  bool Meet(Index shared) const
  {
    return shared == 0 ? bonedecimate::Meet(this->A, this->B)
      : shared == 1    ? MeetBeyondCorner(this->A, this->B)
                       : MeetBeyondEdge(this->A, this->B);
  }
  bool Cross() const
  {
    return testsupport::Cross(this->Both, this->Both.Triangles[0], this->Both.Triangles[1]);
  }
};

class Places
{
public:
  explicit Places(unsigned int seed)
    : Random(seed)
  {
  }
  Vector3 Any() { return { this->One(), this->One(), this->One() }; }
  double One() { return this->Uniform(this->Random); }

  template <typename Place>
  Pair AnyPair(Index shared, const Place& place)
  {
    Pair pair;
    for (int i = 0; i < 6; ++i)
    {
      pair.Both.Points.push_back(place());
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
}

TEST(TrianglePair, MeetsWhereBruteForceFindsThatItDoes)
{
  Places places(3);
  for (const Index shared : { 0, 1, 2 })
  {
    int met = 0;
    for (int round = 0; round < 20000; ++round)
    {
      const Pair pair = places.AnyPair(shared, [&] { return places.Any(); });
      ASSERT_EQ(pair.Meet(shared), pair.Cross()) << shared << " shared, round " << round;
      met += pair.Cross() ? 1 : 0;
    }
    EXPECT_EQ(met > 1000, shared < 2); // folded flat only by intention
  }
}

TEST(TrianglePair, MeetsWhereBruteForceFindsThatItDoesInOnePlane)
{
  Places places(5);
  const Vector3 u(0.3, -0.4, 0.7);
  const Vector3 v(0.2, 0.9, -0.1);
  for (const Index shared : { 0, 1, 2 })
  {
    for (int round = 0; round < 5000; ++round)
    {
      // Along z exactly, and in a plane that rounding bends.
      const Pair flat =
        places.AnyPair(shared, [&] { return Vector3(places.One(), places.One(), 0.5); });
      ASSERT_EQ(flat.Meet(shared), flat.Cross()) << shared << " shared, round " << round;
      const Pair tilted =
        places.AnyPair(shared, [&] { return (places.One() * u + places.One() * v).eval(); });
      EXPECT_TRUE(tilted.Meet(shared) || !tilted.Cross()) << shared << " shared, round " << round;
    }
  }
}

TEST(TrianglePair, NeighboursInAFlatGridDoNotMeet)
{
  const Surface grid = Grid(4);
  for (const Triangle& a : grid.Triangles)
  {
    for (const Triangle& b : grid.Triangles)
    {
      Triangle p = a;
      Triangle q = b;
      const auto isIn = [](const Triangle& t)
      { return [&t](Index v) { return std::find(t.begin(), t.end(), v) != t.end(); }; };
      const auto shared = std::partition(p.begin(), p.end(), isIn(b)) - p.begin();
      std::partition(q.begin(), q.end(), isIn(a));
      if (shared == 2 && p[0] != q[0])
      {
        std::swap(q[0], q[1]);
      }
      const TriangleCorners cornersA = { grid.Points[p[0]], grid.Points[p[1]], grid.Points[p[2]] };
      const TriangleCorners cornersB = { grid.Points[q[0]], grid.Points[q[1]], grid.Points[q[2]] };
      EXPECT_FALSE(shared == 0 && Meet(cornersA, cornersB));
      EXPECT_FALSE(shared == 1 && MeetBeyondCorner(cornersA, cornersB));
      EXPECT_FALSE(shared == 2 && MeetBeyondEdge(cornersA, cornersB));
    }
  }
}

TEST(TrianglePair, FoldedFlatOntoItsNeighbourItMeetsIt)
{
  const TriangleCorners a = { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0.3, 1, 0) };
  const TriangleCorners flat = { a[0], a[1], Vector3(0.6, 0.5, 0) };
  const TriangleCorners across = { a[0], a[1], Vector3(0.6, -0.5, 0) };
  const TriangleCorners raised = { a[0], a[1], Vector3(0.6, 0.5, 1e-6) };
  EXPECT_TRUE(MeetBeyondEdge(a, flat));
  EXPECT_FALSE(MeetBeyondEdge(a, across));
  EXPECT_FALSE(MeetBeyondEdge(a, raised));
}

TEST(TrianglePair, WayIsAsLongAsBruteForceFinds)
{
  Places places(9);
  for (int round = 0; round < 3000; ++round)
  {
    const Pair pair = places.AnyPair(0, [&] { return places.Any(); });
    if (!pair.Cross())
    {
      const auto isFirst = [](const Triangle& t) { return t[0] == 0; };
      const auto isSecond = [](const Triangle& t) { return t[0] == 3; };
      const Way way = WayBetween(pair.A, pair.B);
      const double expected = LeastDistance(pair.Both, isFirst, isSecond);
      EXPECT_NEAR(std::sqrt(way.SquaredLength), expected, 0.02);
      EXPECT_LE(std::sqrt(way.SquaredLength), expected + 1e-12);
    }
  }
}

TEST(TrianglePair, RaysHitWhatTheyGoThrough)
{
  const TriangleCorners t = { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0) };
  EXPECT_EQ(ShootRay({ 0.2, 0.2, -1.0 }, { 0.0, 0.0, 1.0 }, t), RayAnswer::Hits);
  EXPECT_EQ(ShootRay({ 0.2, 0.2, -1.0 }, { 0.0, 0.0, -1.0 }, t), RayAnswer::Misses);
  EXPECT_EQ(ShootRay({ 0.8, 0.8, -1.0 }, { 0.0, 0.0, 1.0 }, t), RayAnswer::Misses);
  EXPECT_EQ(ShootRay({ 0.5, 0.5, -1.0 }, { 0.0, 0.0, 1.0 }, t), RayAnswer::Unclear);
  EXPECT_EQ(ShootRay({ 0.2, 0.2, 0.0 }, { 0.0, 0.0, 1.0 }, t), RayAnswer::Unclear);
}

TEST(FaceGrid, LeavesNoCellOutThatATriangleReachesInto)
{
  const FaceGrid grid(HalfEdgeMesh(Scaled(Icosphere(3, 1.0), 0.5)), 0.0);
  Places places(13);
  for (int round = 0; round < 2000; ++round)
  {
    const TriangleCorners t = { places.Any(), places.Any(), places.Any() };
    const double reach = 0.2 * (1.0 + places.One());
    std::vector<FaceGrid::Key> cells;
    grid.AddCells(t, reach, cells);
    std::sort(cells.begin(), cells.end());
    EXPECT_EQ(std::unique(cells.begin(), cells.end()), cells.end());
    for (int i = 0; i < 20; ++i)
    {
      const double b = 0.5 * (1.0 + places.One());
      const double c = 0.5 * (1.0 + places.One()) * (1.0 - b);
      const Vector3 p = t[0] + b * (t[1] - t[0]) + c * (t[2] - t[0]) +
        reach * places.One() * places.Any().normalized();
      std::vector<FaceGrid::Key> own;
      grid.AddCells({ p, p, p }, 0.0, own);
      EXPECT_TRUE(std::any_of(own.begin(), own.end(),
        [&](FaceGrid::Key cell) { return std::binary_search(cells.begin(), cells.end(), cell); }));
    }
  }
}
