// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of label maps: voxelized again they give every label, each label's surface is closed and
// manifold.
#include "Labels/LabelMap/LabelSurfaces.h"

#include "BruteForce.h"
#include "LabelMaps.h"
#include "Labels/LabelMap/SingleLabel.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
LabelSurfaces Extract(const LabelMap& map, const LabelSurfaceOptions& options = {})
{
  LabelSurfaces result = ExtractLabelSurfaces(MakeLabelImage(map.Labels.data(), map.Grid), options);
  EXPECT_EQ(result.Status, LabelSurfaceStatus::Good);
  return result;
}

/// The value of each voxel's label in surfaces with these points.
std::vector<std::int64_t> Voxelized(
  const LabelSurfaces& surfaces, const Surface& surface, std::size_t axis)
{
  std::vector<std::int64_t> values;
  for (const Index label : VoxelizeLabels(surface, surfaces.Source.OfTriangle, surfaces.Source.Grid,
         surfaces.Source.Background(), axis))
  {
    values.push_back(label == NoLabel ? std::numeric_limits<std::int64_t>::min()
                                      : surfaces.Source.Values[static_cast<std::size_t>(label)]);
  }
  return values;
}

std::size_t WrongVoxels(const LabelMap& map, const LabelSurfaces& surfaces, const Surface& surface)
{
  std::size_t wrong = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<std::int64_t> values = Voxelized(surfaces, surface, axis);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      wrong += values[i] == map.Labels[i] ? 0 : 1;
    }
  }
  return wrong;
}

/// Each point somewhere in its octahedron, scaled about its center.
Surface PointsInOctahedra(const LabelSurfaces& surfaces, double scale, std::uint64_t seed)
{
  Random random(seed);
  Surface moved = surfaces.Surface;
  for (std::size_t p = 0; p < moved.Points.size(); ++p)
  {
    const GridPoint& center = surfaces.Source.OfPoint[p];
    const int odd = std::abs(center[0] % 2) + std::abs(center[1] % 2) + std::abs(center[2] % 2);
    Vector3 offset;
    do
    {
      offset = random.InCube(1.0);
    } while (offset.lpNorm<1>() > 1.0);
    offset *= random.Below(2) == 0 ? 1.0 : 1.0 / offset.lpNorm<1>(); // half of them on its faces
    moved.Points[p] = surfaces.Source.Grid.ToMillimeters(
      0.5 * Vector3(center[0], center[1], center[2]) + scale * 0.5 * odd * offset);
  }
  return moved;
}

void ExpectClosedManifoldLabels(const LabelSurfaces& surfaces)
{
  for (Index label = 0; label <= surfaces.Source.Background(); ++label)
  {
    const SingleLabelSurface single =
      ExtractLabel(surfaces.Surface, surfaces.Source.OfTriangle, label);
    const Topology topology = CountTopology(single.Surface);
    EXPECT_EQ(topology.BoundaryEdges, 0) << "label " << label;
    EXPECT_EQ(topology.NonManifoldEdges, 0) << "label " << label;
    EXPECT_EQ(topology.InconsistentEdges, 0) << "label " << label;
    EXPECT_EQ(topology.NonManifoldPoints, 0) << "label " << label;
    EXPECT_EQ(SignedVolume(single.Surface) > 0.0, label != surfaces.Source.Background());
  }
}

bool SameResult(const LabelSurfaces& a, const LabelSurfaces& b)
{
  return SameBytes(a.Surface, b.Surface) && a.Source.OfPoint == b.Source.OfPoint &&
    a.Source.OfTriangle == b.Source.OfTriangle && a.Source.Values == b.Source.Values;
}

/// A plate of one voxel with a label on each side, and a hole in it.
LabelMap ThinWall()
{
  return MakeLabelMap({ 9, 8, 7 },
    [](const std::array<Index, 3>& voxel)
    {
      const bool isHole = voxel[1] == 4 && voxel[2] == 3;
      return voxel[0] == 4 && !isHole ? 5 : voxel[0] < 4 && voxel[2] > 0 ? 2 : 0;
    });
}
}

class NoiseSurfaces : public testing::TestWithParam<int>
{
protected:
  LabelMap Map = NoiseLabels({ 11, 9, 10 }, GetParam(), 5);
};

TEST_P(NoiseSurfaces, GiveEveryVoxelItsLabel)
{
  const LabelSurfaces surfaces = Extract(this->Map);
  EXPECT_EQ(WrongVoxels(this->Map, surfaces, surfaces.Surface), 0U);
}

TEST_P(NoiseSurfaces, AreClosedAndManifoldLabelByLabel)
{
  ExpectClosedManifoldLabels(Extract(this->Map));
}

TEST_P(NoiseSurfaces, GiveEveryVoxelItsLabelWhereverPointsLieInTheirOctahedra)
{
  const LabelSurfaces surfaces = Extract(this->Map);
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    EXPECT_EQ(WrongVoxels(this->Map, surfaces, PointsInOctahedra(surfaces, 0.999, seed)), 0U);
  }
  EXPECT_GT(WrongVoxels(this->Map, surfaces, PointsInOctahedra(surfaces, 1.5, 0)), 0U)
    << "larger octahedra contain voxel centers";
}

TEST_P(NoiseSurfaces, HaveTheSameBytesForAnyNumberOfThreads)
{
  const LabelMap map = NoiseLabels({ 12, 7, 61 }, GetParam(), 6);
  LabelSurfaceOptions options;
  options.Threads = 1;
  const LabelSurfaces one = Extract(map, options);
  for (const int threads : { 2, 4, 8 })
  {
    options.Threads = threads;
    EXPECT_TRUE(SameResult(Extract(map, options), one)) << threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(
  Labels, NoiseSurfaces, testing::Values(2, 3, 4, 9), testing::PrintToStringParamName());

TEST(LabelSurfaces, OfAVoxelAreAnOctahedron)
{
  const LabelSurfaces surfaces =
    Extract(MakeLabelMap({ 1, 1, 1 }, [](const std::array<Index, 3>&) { return 7; }));
  EXPECT_EQ(surfaces.Surface.Points.size(), 6U);
  EXPECT_EQ(surfaces.Surface.Triangles.size(), 8U);
  EXPECT_NEAR(SignedVolume(surfaces.Surface), 1.0 / 6.0, 1e-15);
  EXPECT_EQ(surfaces.Source.Values, (std::vector<std::int64_t>{ 7, 0 }));
  const std::set<GridPoint> points(surfaces.Source.OfPoint.begin(), surfaces.Source.OfPoint.end());
  EXPECT_EQ(points,
    (std::set<GridPoint>{
      { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } }));
}

TEST(LabelSurfaces, OfAThinWallKeepItClosed)
{
  const LabelMap map = ThinWall();
  const LabelSurfaces surfaces = Extract(map);
  EXPECT_EQ(WrongVoxels(map, surfaces, surfaces.Surface), 0U);
  ExpectClosedManifoldLabels(surfaces);
  const SingleLabelSurface wall = ExtractLabel(surfaces.Surface, surfaces.Source.OfTriangle, 1);
  EXPECT_EQ(CountTopology(wall.Surface).EulerNumber, 0) << "a plate with a hole";
}

TEST(LabelSurfaces, HaveWallsOnce)
{
  const LabelMap map = EllipsoidLabels({ 20, 18, 16 });
  const LabelSurfaces surfaces = Extract(map);
  std::set<BoundaryLabels> walls;
  std::set<std::array<Index, 3>> corners;
  for (std::size_t t = 0; t < surfaces.Surface.Triangles.size(); ++t)
  {
    Triangle sorted = surfaces.Surface.Triangles[t];
    std::sort(sorted.begin(), sorted.end());
    EXPECT_TRUE(corners.insert(sorted).second) << "two triangles of the same points";
    walls.insert(surfaces.Source.OfTriangle[t]);
  }
  EXPECT_EQ(surfaces.Source.Values, (std::vector<std::int64_t>{ 1, 2, 3, 0 }));
  EXPECT_EQ(walls, (std::set<BoundaryLabels>{ { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 } }));
  EXPECT_EQ(WrongVoxels(map, surfaces, surfaces.Surface), 0U);
  ExpectClosedManifoldLabels(surfaces);
}

TEST(LabelSurfaces, OfObliqueAndLeftHandedGridsHaveOutwardNormals)
{
  LabelMap map = NoiseLabels({ 8, 7, 9 }, 4, 11);
  for (const bool isMirrored : { false, true })
  {
    map.Grid = ObliqueGrid({ 8, 7, 9 }, isMirrored);
    const LabelSurfaces surfaces = Extract(map);
    EXPECT_EQ(WrongVoxels(map, surfaces, surfaces.Surface), 0U);
    EXPECT_EQ(WrongVoxels(map, surfaces, PointsInOctahedra(surfaces, 0.999, 1)), 0U);
    ExpectClosedManifoldLabels(surfaces);
  }
}

TEST(LabelSurfaces, OfAMapThatIsOneLabelAreAClosedBoxOrNothing)
{
  const LabelMap map = MakeLabelMap({ 4, 5, 6 }, [](const std::array<Index, 3>&) { return 1; });
  const LabelSurfaces closed = Extract(map);
  EXPECT_EQ(CountTopology(closed.Surface).EulerNumber, 2);
  EXPECT_EQ(CountTopology(closed.Surface).BoundaryEdges, 0);
  LabelSurfaceOptions options;
  options.Closed = false;
  EXPECT_TRUE(Extract(map, options).Surface.Triangles.empty());
}

/// The coordinates of the corners and the labels of each triangle.
using TriangleKey = std::array<double, 11>;
std::multiset<TriangleKey> TrianglesWithin(const LabelSurfaces& surfaces)
{
  std::multiset<TriangleKey> keys;
  for (std::size_t t = 0; t < surfaces.Surface.Triangles.size(); ++t)
  {
    TriangleKey key = {};
    bool isWithin = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto id = static_cast<std::size_t>(surfaces.Surface.Triangles[t][k]);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const Index at = surfaces.Source.OfPoint[id][axis];
        isWithin = isWithin && at >= 0 && at <= 2 * (surfaces.Source.Grid.Dimensions[axis] - 1);
        key[3 * k + axis] = surfaces.Surface.Points[id][static_cast<Index>(axis)];
      }
    }
    key[9] = surfaces.Source.OfTriangle[t][0];
    key[10] = surfaces.Source.OfTriangle[t][1];
    if (isWithin)
    {
      keys.insert(key);
    }
  }
  return keys;
}

TEST(LabelSurfaces, OpenOnesAreThePartOfTheClosedOnesWithinTheVoxelCenters)
{
  const LabelMap map = NoiseLabels({ 8, 9, 7 }, 4, 12);
  LabelSurfaceOptions options;
  options.Closed = false;
  const LabelSurfaces open = Extract(map, options);
  EXPECT_EQ(TrianglesWithin(open).size(), open.Surface.Triangles.size());
  EXPECT_EQ(TrianglesWithin(open), TrianglesWithin(Extract(map)));
  EXPECT_EQ(WhatIsWrong(open.Surface), "");
}

/// Layer, kind of point (in the layer, between layers, inside cells), y, x, and axis of the edge or
/// face.
using PointOrder = std::array<int, 5>;
PointOrder OrderOf(const GridPoint& p)
{
  const std::array<int, 3> odd = { std::abs(p[0] % 2), std::abs(p[1] % 2), std::abs(p[2] % 2) };
  const int sum = odd[0] + odd[1] + odd[2];
  const int kind = sum == 3 ? 2 : odd[2];
  const int axis = sum == 1 ? odd[1] : sum == 2 ? 2 + odd[0] : 0;
  return { (p[2] - odd[2]) / 2, kind, (p[1] - odd[1]) / 2, (p[0] - odd[0]) / 2, axis };
}

TEST(LabelSurfaces, AreInOrderOfLayersAndVoxels)
{
  const LabelSurfaces surfaces = Extract(NoiseLabels({ 7, 6, 11 }, 5, 13));
  std::vector<PointOrder> points;
  for (const GridPoint& point : surfaces.Source.OfPoint)
  {
    points.push_back(OrderOf(point));
  }
  EXPECT_TRUE(std::is_sorted(points.begin(), points.end()));
  std::vector<std::array<double, 3>> cells;
  for (const Triangle& t : surfaces.Surface.Triangles)
  {
    const auto& p = surfaces.Surface.Points;
    const Vector3 sum = p[static_cast<std::size_t>(t[0])] + p[static_cast<std::size_t>(t[1])] +
      p[static_cast<std::size_t>(t[2])];
    cells.push_back(
      { std::floor(sum[2] / 3.0), std::floor(sum[1] / 3.0), std::floor(sum[0] / 3.0) });
  }
  EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
}

TEST(LabelSurfaces, HaveAPointOnEachGridEdgeWithDifferentEnds)
{
  const LabelMap map = NoiseLabels({ 6, 5, 7 }, 3, 14);
  const LabelSurfaces surfaces = Extract(map);
  std::multiset<GridPoint> edges;
  for (std::size_t p = 0; p < surfaces.Source.OfPoint.size(); ++p)
  {
    const GridPoint& at = surfaces.Source.OfPoint[p];
    if (std::abs(at[0] % 2) + std::abs(at[1] % 2) + std::abs(at[2] % 2) == 1)
    {
      EXPECT_EQ(surfaces.Surface.Points[p], Vector3(0.5 * at[0], 0.5 * at[1], 0.5 * at[2]));
      edges.insert(at);
    }
  }
  const auto labelAt = [&](Index x, Index y, Index z)
  {
    const bool isInside = x >= 0 && y >= 0 && z >= 0 && x < 6 && y < 5 && z < 7;
    return isInside ? map.Labels[static_cast<std::size_t>(x + 6 * (y + 5 * z))] : 0;
  };
  std::multiset<GridPoint> expected;
  for (Index z = -1; z < 7; ++z)
  {
    for (Index y = -1; y < 5; ++y)
    {
      for (Index x = -1; x < 6; ++x)
      {
        const GridPoint at = { 2 * x, 2 * y, 2 * z };
        const auto label = labelAt(x, y, z);
        label != labelAt(x + 1, y, z) ? void(expected.insert({ at[0] + 1, at[1], at[2] })) : void();
        label != labelAt(x, y + 1, z) ? void(expected.insert({ at[0], at[1] + 1, at[2] })) : void();
        label != labelAt(x, y, z + 1) ? void(expected.insert({ at[0], at[1], at[2] + 1 })) : void();
      }
    }
  }
  EXPECT_EQ(edges, expected);
}

TEST(LabelSurfaces, HaveFacePointsAtTheMeanOfTheMiddlesOfEdgesWithDifferentEnds)
{
  const LabelMap map = NoiseLabels({ 6, 5, 7 }, 4, 15);
  LabelSurfaceOptions open;
  open.Closed = false;
  const LabelSurfaces surfaces = Extract(map, open);
  const auto labelAt = [&](const Vector3& x)
  { return map.Labels[static_cast<std::size_t>(x[0] + 6 * (x[1] + 5 * x[2]))]; };
  std::size_t facePoints = 0;
  for (std::size_t p = 0; p < surfaces.Source.OfPoint.size(); ++p)
  {
    const GridPoint& at = surfaces.Source.OfPoint[p];
    if (at[0] % 2 + at[1] % 2 + at[2] % 2 != 2)
    {
      continue;
    }
    ++facePoints;
    const Index normal = at[0] % 2 == 0 ? 0 : at[1] % 2 == 0 ? 1 : 2;
    const Vector3 u = 0.5 * Vector3::Unit((normal + 1) % 3);
    const Vector3 v = 0.5 * Vector3::Unit((normal + 2) % 3);
    const Vector3 center = 0.5 * Vector3(at[0], at[1], at[2]);
    const std::array<Vector3, 4> corners = { center - u - v, center + u - v, center + u + v,
      center - u + v };
    Vector3 sum = Vector3::Zero();
    int middles = 0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Vector3& a = corners[k];
      const Vector3& b = corners[(k + 1) % 4];
      if (labelAt(a) != labelAt(b))
      {
        sum += 0.5 * (a + b);
        ++middles;
      }
    }
    EXPECT_LT((surfaces.Surface.Points[p] - sum / middles).norm(), 1e-14);
  }
  EXPECT_GT(facePoints, 100U);
}
