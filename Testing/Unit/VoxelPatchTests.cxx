// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Whether voxel centers lie between two patches, against winding numbers by solid angles.
#include "Labels/VoxelGuard/VoxelPatch.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr BoundaryLabels Single = { 0, 1 };

FixedPoint Fixed(const Vector3& voxels)
{
  return FixedPointFrame(VoxelGrid()).Convert(voxels);
}

FixedTriangle Fixed(const std::array<Vector3, 3>& corners)
{
  return { Fixed(corners[0]), Fixed(corners[1]), Fixed(corners[2]) };
}

/// The solid angle of a triangle (Van Oosterom and Strackee 1983), as a fraction of the sphere.
double SolidAngle(const std::array<Vector3, 3>& corners, const Vector3& p)
{
  const Vector3 a = corners[0] - p;
  const Vector3 b = corners[1] - p;
  const Vector3 c = corners[2] - p;
  const double x = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() +
    c.dot(a) * b.norm();
  return std::atan2(a.dot(b.cross(c)), x) / (2.0 * 3.14159265358979323846);
}

/// Fans around two positions with the same ring: what a move of the middle vertex changes.
struct Fans
{
  std::vector<std::array<Vector3, 3>> Old;
  std::vector<std::array<Vector3, 3>> New;
};

Fans RandomFans(Random& random)
{
  const Index count = 3 + random.Below(5);
  const Vector3 middle = random.InCube(2.0);
  const double size = random.Between(0.3, 4.0);
  const Vector3 before = middle + random.InCube(0.6 * size);
  const Vector3 after = middle + random.InCube(0.6 * size);
  std::vector<Vector3> ring;
  for (Index i = 0; i < count; ++i)
  {
    ring.emplace_back(middle + random.InCube(size));
  }
  Fans fans;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    fans.Old.push_back({ before, ring[i], ring[(i + 1) % ring.size()] });
    fans.New.push_back({ after, ring[i], ring[(i + 1) % ring.size()] });
  }
  return fans;
}

bool AnyWindingDiffers(const Fans& fans)
{
  for (int x = -7; x <= 7; ++x)
  {
    for (int y = -7; y <= 7; ++y)
    {
      for (int z = -7; z <= 7; ++z)
      {
        double sum = 0.0;
        for (std::size_t i = 0; i < fans.Old.size(); ++i)
        {
          const Vector3 p(x, y, z);
          sum += SolidAngle(fans.Old[i], p) - SolidAngle(fans.New[i], p);
        }
        if (std::abs(sum) > 0.5)
        {
          return true;
        }
      }
    }
  }
  return false;
}

VoxelPatch PatchOf(const Fans& fans)
{
  VoxelPatch patch;
  for (std::size_t i = 0; i < fans.Old.size(); ++i)
  {
    patch.AddOld(Fixed(fans.Old[i]), Single);
    patch.AddNew(Fixed(fans.New[i]), Single);
  }
  return patch;
}

using Corners = std::array<Vector3, 3>;

/// The square [-1, 1] x [-1, 1] around a voxel center at a height, as four triangles around its
/// middle.
std::vector<Corners> Square(double height, double middleHeight)
{
  const Vector3 middle(0.1, 0.2, middleHeight);
  const std::array<Vector3, 4> ring = { Vector3(-0.9, -0.9, height), Vector3(0.9, -0.9, height),
    Vector3(0.9, 0.9, height), Vector3(-0.9, 0.9, height) };
  std::vector<Corners> faces;
  for (std::size_t i = 0; i < 4; ++i)
  {
    faces.push_back({ middle, ring[i], ring[(i + 1) % 4] });
  }
  return faces;
}

bool Keeps(const std::vector<Corners>& before, const BoundaryLabels& labelsBefore,
  const std::vector<Corners>& after, const BoundaryLabels& labelsAfter, bool isOpen = false)
{
  VoxelPatch patch;
  for (const Corners& face : before)
  {
    patch.AddOld(Fixed(face), labelsBefore);
  }
  for (const Corners& face : after)
  {
    patch.AddNew(Fixed(face), labelsAfter);
  }
  return patch.KeepsLabels(isOpen);
}
}

TEST(VoxelPatches, KeepLabelsExactlyWhereNoWindingNumberDiffers)
{
  Random random(11);
  int kept = 0;
  constexpr int runs = 1500;
  for (int i = 0; i < runs; ++i)
  {
    const Fans fans = RandomFans(random);
    VoxelPatch patch = PatchOf(fans);
    const bool keeps = patch.KeepsLabels(false);
    ASSERT_EQ(keeps, !AnyWindingDiffers(fans)) << i;
    EXPECT_EQ(patch.KeepsLabels(true), keeps) << "a closed change is the same along all axes";
    kept += keeps ? 1 : 0;
  }
  EXPECT_GT(kept, runs / 5);
  EXPECT_LT(kept, 4 * runs / 5);
}

TEST(VoxelPatches, AreNearACenterExactlyWithinTheMargin)
{
  const std::vector<Corners> low = Square(-0.5, -0.5);
  for (const double height : { -0.3, -0.011, -0.009, 0.009, 0.011 })
  {
    VoxelPatch patch;
    const Corners above = { Vector3(-2, -2, height), Vector3(2, -2, height),
      Vector3(0, 3, height) };
    patch.AddNew(Fixed(above), Single);
    patch.AddOld(Fixed(low[0]), Single);
    EXPECT_EQ(patch.IsNearCenter(0.01), std::abs(height) < 0.01) << height;
  }
}

/// Distances of centers beside the triangle are those to its edges and corners.
TEST(VoxelPatches, AreNearACenterBesideTheTriangleAsWell)
{
  for (const double gap : { 0.008, 0.012 })
  {
    VoxelPatch besideEdge;
    besideEdge.AddNew(
      Fixed(Corners{ Vector3(gap, -0.7, -0.1), Vector3(gap, 0.7, 0.1), Vector3(0.8, 0.3, 0.1) }),
      Single);
    VoxelPatch besideCorner;
    const double along = gap / std::sqrt(3.0);
    besideCorner.AddNew(Fixed(Corners{ Vector3(along, along, along), Vector3(0.5, 0.7, 0.6),
                          Vector3(0.8, 0.3, 0.4) }),
      Single);
    EXPECT_EQ(besideCorner.IsNearCenter(0.01), gap < 0.01) << gap;
    EXPECT_EQ(besideEdge.IsNearCenter(0.01), gap < 0.01) << gap;
  }
}

TEST(VoxelPatches, OldTrianglesMayBeNearACenter)
{
  VoxelPatch patch;
  patch.AddOld(Fixed(Square(0.0, 0.0)[0]), Single);
  EXPECT_FALSE(patch.IsNearCenter(0.01));
}

TEST(VoxelPatches, ThatExchangeALabelDoNotKeepTheLabels)
{
  const std::vector<Corners> low = Square(-0.5, 0.25);
  const std::vector<Corners> high = Square(-0.5, 0.5);
  EXPECT_TRUE(Keeps(low, { 0, 2 }, high, { 0, 2 }));
  EXPECT_FALSE(Keeps(low, { 0, 2 }, Square(-0.5, -0.25), { 0, 2 }));
  EXPECT_FALSE(Keeps(low, { 0, 2 }, high, { 1, 2 }));
  EXPECT_FALSE(Keeps(low, { 0, 2 }, high, { 0, 1 }));
}

TEST(VoxelPatches, OfAnOpenSurfaceMayNotUncoverAnEdgeOfTheGrid)
{
  const std::vector<Corners> whole = Square(-0.5, -0.5);
  const std::vector<Corners> three(whole.begin(), whole.begin() + 3);
  EXPECT_TRUE(Keeps(three, Single, three, Single, true));
  const std::vector<Corners> smallSquare = Square(-0.5, -0.4);
  EXPECT_TRUE(Keeps(whole, Single, smallSquare, Single, true));
  std::vector<Corners> without = whole; // the side with the line through the voxel center
  without.erase(without.begin() + 3);
  without.erase(without.begin());
  EXPECT_FALSE(Keeps(whole, Single, without, Single, true));
}

/// A boundary in the plane of the outermost voxel centers: it ends on the grid's edges, whichever
/// end of the volume that is.
TEST(VoxelPatches, OfAnOpenSurfaceAreGuardedOnBothEndsOfTheVolume)
{
  for (const double side : { -1.0, 1.0 })
  {
    const auto strip = [&](double at) -> std::vector<Corners>
    {
      const Vector3 a(0, -0.4, 0.5);
      const Vector3 b(0, at, 0.5);
      const Vector3 c(side * 0.7, 0.5, 0.5);
      return { { a, b, c } };
    };
    EXPECT_TRUE(Keeps(strip(0.6), Single, strip(0.4), Single, true)) << side;
    EXPECT_FALSE(Keeps(strip(0.6), Single, strip(-0.2), Single, true)) << side;
  }
}

TEST(VoxelPatches, OfAnOpenSurfaceMayNotBringTheRimNearAnEdgeOfTheGrid)
{
  constexpr double margin = 1e-3;
  const auto isNear = [](const std::array<Vector3, 2>& before, const std::array<Vector3, 2>& after)
  {
    VoxelPatch patch;
    patch.AddOldRim(Fixed(before[0]), Fixed(before[1]), margin);
    patch.AddNewRim(Fixed(after[0]), Fixed(after[1]), margin);
    return patch.IsRimNearOtherEdges();
  };
  for (Index axis = 0; axis < 3; ++axis)
  {
    // Past the line along the axis through (., 1, 1), at a height between two centers.
    const auto segment = [axis](double distance, double height) -> std::array<Vector3, 2>
    {
      std::array<Vector3, 2> ends;
      for (const double side : { -1.0, 1.0 })
      {
        Vector3& end = ends[side < 0.0 ? 0 : 1];
        end[axis] = height;
        end[(axis + 1) % 3] = 1.0 + 0.7 * side;
        end[(axis + 2) % 3] = 1.0 + 0.7 * side + distance * std::sqrt(2.0);
      }
      return ends;
    };
    EXPECT_FALSE(isNear(segment(0.1, 2.5), segment(1.01 * margin, 2.5))) << axis;
    EXPECT_TRUE(isNear(segment(0.1, 2.5), segment(0.99 * margin, 2.5))) << axis;
    EXPECT_TRUE(isNear(segment(0.1, 2.5), segment(-0.99 * margin, -2.5))) << axis;
    EXPECT_FALSE(isNear(segment(0.0, 2.4), segment(0.5 * margin, 2.6))) << axis;
    EXPECT_TRUE(isNear(segment(0.0, 2.4), segment(0.5 * margin, 3.4))) << axis;
    EXPECT_FALSE(isNear(segment(0.0, 2.4), { Vector3(0.4, 0.4, 0.4), Vector3(0.6, 0.6, 0.6) }));
  }
}

TEST(VoxelPatches, BeyondTheReachOfThePredicatesAreRejected)
{
  const auto needle = [](double length) -> std::vector<Corners> {
    return { { Vector3(0.1, 0.1, 0.1), Vector3(length, 0.1, 0.2), Vector3(0.1, 0.3, 0.1) } };
  };
  EXPECT_TRUE(Keeps(needle(1000.0), Single, needle(1000.0), Single));
  EXPECT_FALSE(Keeps(needle(1030.0), Single, needle(1030.0), Single));
  EXPECT_FALSE(Keeps(needle(1e30), Single, needle(1e30), Single));
}

TEST(FixedPoints, FollowSpacingAndDirectionOfTheGrid)
{
  VoxelGrid grid;
  grid.Origin = { 10, 20, 30 };
  grid.Spacing = { 0.5, 2, 4 };
  grid.Direction << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const FixedPointFrame frame(grid);
  const FixedPoint at = frame.Convert(grid.ToMillimeters({ 3, -5, 7.25 }));
  EXPECT_EQ(
    at, (FixedPoint{ 3 * UnitsOfVoxel, -5 * UnitsOfVoxel, 7 * UnitsOfVoxel + UnitsOfVoxel / 4 }));
  const FixedPoint far = frame.Convert({ 1e30, -1e30, 0 });
  EXPECT_NE(far[0] % UnitsOfVoxel, 0);
  EXPECT_NE(far[2] % UnitsOfVoxel, 0);
}
