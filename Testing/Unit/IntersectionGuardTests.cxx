// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// With a largest error, gaps keep half of their width and nothing intersects that did not before.
// By brute force.
#include "Crossings.h"
#include "GuardedOptions.h"
#include "Proof/Guard/GapRule.h"
#include "Proof/Guard/TrianglePair.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <utility>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{

/// The surface of a block of unit cubes whose points are mapped by `positionOf`.
Surface Block(
  const std::array<Index, 3>& cubes, const std::function<Vector3(const Vector3&)>& positionOf)
{
  Surface block;
  std::map<std::array<Index, 3>, Index> ids;
  const auto pointOf = [&](const std::array<Index, 3>& at)
  {
    const auto [known, isNew] = ids.try_emplace(at, static_cast<Index>(block.Points.size()));
    if (isNew)
    {
      block.Points.push_back(positionOf(Vector3(at[0], at[1], at[2])));
    }
    return known->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const bool isHigh : { false, true })
    {
      for (Index i = 0; i < cubes[u]; ++i)
      {
        for (Index j = 0; j < cubes[v]; ++j)
        {
          const auto corner = [&](Index a, Index b)
          {
            std::array<Index, 3> at{};
            at[axis] = isHigh ? cubes[axis] : 0;
            at[u] = i + (isHigh ? a : b);
            at[v] = j + (isHigh ? b : a);
            return pointOf(at);
          };
          const std::array<Index, 4> p = { corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1) };
          block.Triangles.push_back({ p[0], p[1], p[2] });
          block.Triangles.push_back({ p[0], p[2], p[3] });
        }
      }
    }
  }
  return block;
}

/// Two parallel open wavy surfaces with that distance (mm).
Surface WavySurfaces(double gap, Index cells = 20)
{
  Surface low = HeightField(cells, 0.03, 5);
  Surface high = Moved(HeightField(cells, 0.03, 6), Vector3(0.0, 0.0, gap));
  for (Surface* surface : { &low, &high })
  {
    for (Vector3& p : surface->Points)
    {
      p[2] += 0.35 * std::sin(0.9 * p[0]) * std::cos(0.8 * p[1]);
    }
  }
  return Together(low, high);
}

/// A tube along z of radii 4 and 6, open along its length by a slit that waves and is that wide
/// (mm).
Surface SlitTube(double slit)
{
  constexpr Index around = 60;
  return Block({ around, 4, 24 },
    [slit](const Vector3& at)
    {
      const double pi = 3.14159265358979323846;
      const double radius = 6.0 - 0.5 * at[1];
      const double z = 0.6 * at[2];
      const double from = std::asin(0.5 * slit / radius);
      const double angle = from + (2.0 * pi - 2.0 * from) * at[0] / around;
      const double toSlit = std::min(angle, 2.0 * pi - angle);
      const double nearSlit = std::pow(std::max(0.0, 1.0 - toSlit * toSlit), 2.0);
      const double wave = 0.3 * nearSlit * std::sin(1.3 * z + 0.8 * radius);
      return Vector3(radius * std::cos(angle), radius * std::sin(angle) + wave, z);
    });
}

Vector3 NormalOf(const Surface& surface, const Triangle& t)
{
  return (surface.Points[t[1]] - surface.Points[t[0]])
    .cross(surface.Points[t[2]] - surface.Points[t[0]])
    .normalized();
}

/// mm, between the two walls of the slit, away from their rims.
double WidthOfSlit(const Surface& tube)
{
  const auto isWall = [&tube](const Triangle& t, double side)
  {
    const Vector3 middle = (tube.Points[t[0]] + tube.Points[t[1]] + tube.Points[t[2]]) / 3.0;
    return middle[0] > 3.5 && std::abs(middle[1]) < 1.0 && side * NormalOf(tube, t)[1] > 0.8;
  };
  return LeastDistance(
    tube, [&](const Triangle& t) { return isWall(t, 1.0); },
    [&](const Triangle& t) { return isWall(t, -1.0); });
}

/// A closed plate of that thickness (mm), 22 mm long and wide.
Surface ThinPlate(double thickness)
{
  return Block({ 36, 36, 1 },
    [thickness](const Vector3& at)
    {
      const double x = 0.6 * at[0];
      const double y = 0.6 * at[1];
      return Vector3(x, y, thickness * at[2] + 0.4 * std::sin(1.1 * x) * std::cos(0.9 * y));
    });
}

TriangleCorners CornersOf(const Surface& surface, const Triangle& t)
{
  return { surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]] };
}

/// mm, between triangles of the upper and of the lower side that have no corner in common and face
/// each other: the way between them is within 45 degrees of both normals. At the rim, where both
/// sides end, others are nearer.
double ThicknessOf(const Surface& surface)
{
  constexpr double leastCosine = 0.71;
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& upper : surface.Triangles)
  {
    const Vector3 normal = NormalOf(surface, upper);
    for (const Triangle& lower : surface.Triangles)
    {
      const Vector3 other = NormalOf(surface, lower);
      const bool areOpposed = normal[2] > 0.7 && other[2] < -0.7 &&
        std::none_of(lower.begin(), lower.end(),
          [&](Index v) { return std::find(upper.begin(), upper.end(), v) != upper.end(); });
      if (areOpposed)
      {
        const Connection way =
          ShortestConnection(CornersOf(surface, upper), CornersOf(surface, lower));
        const double length = std::sqrt(way.SquaredLength);
        const bool areFacing = way.FromAToB.dot(normal) < -leastCosine * length &&
          way.FromAToB.dot(other) > leastCosine * length;
        least = areFacing ? std::min(least, length) : least;
      }
    }
  }
  return least;
}
}

TEST(IntersectionGuard, FragmentGapAgreesWithBruteForce)
{
  const std::vector<Surface> shapes = { ManyComponents(7), WavySurfaces(0.3, 8), NestedSpheres(2),
    Together(Icosphere(2, 1.0), Moved(Icosphere(2, 1.0), Vector3(1.5, 0.4, 0.0))) };
  for (const Surface& shape : shapes)
  {
    const double expected = LeastDistanceOfComponents(shape);
    EXPECT_LE(MinFragmentGap(shape), expected + 1e-12);
    EXPECT_GE(MinFragmentGap(shape), expected - 0.02);
  }
  EXPECT_TRUE(std::isinf(MinFragmentGap(Icosphere(2, 1.0))));
}

TEST(GapRule, AreTheDistancesToWhatFacesAcross)
{
  const Surface surfaces = Together(Grid(6), Moved(Grid(6), Vector3(0.0, 0.0, 0.3)));
  const GapRule gaps(surfaces, 2.0, 1);
  const Surface plate =
    Block({ 6, 6, 1 }, [](const Vector3& at) { return Vector3(at[0], at[1], 0.3 * at[2]); });
  const GapRule gapsOfPlate(plate, 2.0, 1);
  for (std::size_t i = 0; i < surfaces.Points.size(); ++i)
  {
    const Gap& gap = gaps.Of(static_cast<Index>(i));
    EXPECT_NEAR(gap.BetweenFragments, 0.3F, 1e-6F);
    EXPECT_TRUE(std::isinf(gap.WithinFragment)); // flat: nothing faces anything
  }
  for (std::size_t i = 0; i < plate.Points.size(); ++i)
  {
    const Vector3& p = plate.Points[i];
    const bool isInside = p[0] > 0.5 && p[0] < 5.5 && p[1] > 0.5 && p[1] < 5.5;
    EXPECT_TRUE(
      !isInside || std::abs(gapsOfPlate.Of(static_cast<Index>(i)).WithinFragment - 0.3F) < 1e-6F);
    EXPECT_TRUE(std::isinf(gapsOfPlate.Of(static_cast<Index>(i)).BetweenFragments));
  }
}

TEST(IntersectionGuard, SurfacesNearerThanTheErrorKeepHalfOfTheirGap)
{
  const Surface input = WavySurfaces(0.3);
  const double before = LeastDistanceOfComponents(input);
  for (const Mode mode : ProvingModes())
  {
    const Surface result = Decimate(input, Guarded(mode, 0.5)).Surface;
    EXPECT_GE(LeastDistanceOfComponents(result), 0.5 * before) << WordOf(mode);
    EXPECT_EQ(CountCrossings(result), 0) << WordOf(mode);
    EXPECT_LT(result.Triangles.size(), input.Triangles.size() / 4) << WordOf(mode);
  }
}

TEST(IntersectionGuard, GapsMayCloseWithoutTheOption)
{
  bool isLost = false;
  for (const double gap : { 0.1, 0.2, 0.3 })
  {
    const Surface input = WavySurfaces(gap);
    const Surface result = Decimate(input, Guarded(Mode::Fast, 0.5, false)).Surface;
    isLost = isLost || LeastDistanceOfComponents(result) < 0.5 * LeastDistanceOfComponents(input);
  }
  EXPECT_TRUE(isLost);
}

TEST(IntersectionGuard, WallsOfAFractureStayApart)
{
  const Surface input = SlitTube(0.3);
  ASSERT_EQ(CountCrossings(input), 0);
  const double before = WidthOfSlit(input);
  ASSERT_GT(before, 0.1);
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    const Surface result = Decimate(input, Guarded(mode, 0.5)).Surface;
    EXPECT_GE(WidthOfSlit(result), 0.5 * before) << WordOf(mode);
    EXPECT_EQ(CountCrossings(result), 0) << WordOf(mode);
    EXPECT_LT(result.Triangles.size(), input.Triangles.size() / 3) << WordOf(mode);
  }
}

TEST(IntersectionGuard, AThinPlateKeepsHalfOfItsThickness)
{
  const Surface input = ThinPlate(0.2);
  const double before = 0.18; // mm; its sides are 0.2 mm apart upright, where it is steep less
  ASSERT_GT(ThicknessOf(input), 0.95 * before);
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    const Surface result = Decimate(input, Guarded(mode, 0.5)).Surface;
    EXPECT_GE(ThicknessOf(result), 0.5 * before) << WordOf(mode);
    EXPECT_EQ(CountCrossings(result), 0) << WordOf(mode);
    EXPECT_LT(result.Triangles.size(), input.Triangles.size() / 3) << WordOf(mode);
  }
}

TEST(IntersectionGuard, FoldsDoNotCutThroughThemselves)
{
  const Surface input = BumpySphere(4, 10.0, 0.3, 2);
  ASSERT_EQ(CountCrossings(input), 0);
  const Surface without = Decimate(input, Guarded(Mode::Balanced, 0.8, false)).Surface;
  const Surface with = Decimate(input, Guarded(Mode::Balanced, 0.8)).Surface;
  EXPECT_GT(CountCrossings(without), 0);
  EXPECT_EQ(CountCrossings(with), 0);
  EXPECT_LT(with.Triangles.size(), input.Triangles.size() / 3);
}

TEST(IntersectionGuard, ASmallFragmentIsNotSwallowed)
{
  Surface bumps = Grid(24);
  for (Vector3& p : bumps.Points)
  {
    p[2] += 0.6 * std::sin(1.1 * p[0]) * std::sin(1.1 * p[1]);
  }
  Surface input = bumps;
  for (const double x : { 4.3, 7.1, 12.8, 15.7, 18.5 })
  {
    input = Together(input, Moved(Scaled(Tetrahedron(), 0.1), Vector3(x, 4.3, 0.0)));
    input = Together(input, Moved(Scaled(Tetrahedron(), 0.1), Vector3(x, 12.8, 0.0)));
  }
  const double before = LeastDistanceOfComponents(input);
  ASSERT_GT(before, 0.1);
  const Surface result = Decimate(input, Guarded(Mode::Fast, 0.8)).Surface;
  EXPECT_GE(LeastDistanceOfComponents(result), 0.5 * before);
  const std::vector<Surface> parts = SplitComponents(result);
  EXPECT_EQ(parts.size(), 11U);
  EXPECT_LT(parts[0].Triangles.size(), bumps.Triangles.size() / 2);
}

TEST(IntersectionGuard, GivesTheSameBytesForAnyNumberOfThreads)
{
  const Surface input = WavySurfaces(0.4, 96);
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    Options options = Guarded(mode, 0.2);
    options.TargetNumberOfTriangles = 32000; // of 36,864
    ExpectTheSameBytesForAnyNumberOfThreads(input, options);
  }
}

TEST(IntersectionGuard, CostsNothingWithoutALargestError)
{
  const Surface input = WavySurfaces(0.3);
  Options options = Triangles(600);
  for (const Mode mode : AllModes())
  {
    options = InMode(mode, options);
    options.IntersectionGuard = true;
    const Surface with = Decimate(input, options).Surface;
    options.IntersectionGuard = false;
    EXPECT_TRUE(SameBytes(with, Decimate(input, options).Surface)) << WordOf(mode);
  }
}

TEST(IntersectionGuard, FragmentGapIsInTheReport)
{
  const Surface input = WavySurfaces(0.3);
  Options options = Guarded(Mode::Fast, 0.5);
  options.MeasureDistances = true;
  const Result result = Decimate(input, options);
  ASSERT_TRUE(result.Report.FragmentGapMeasured);
  EXPECT_NEAR(result.Report.Gap.Input, LeastDistanceOfComponents(input), 0.01);
  EXPECT_NEAR(result.Report.Gap.Output, LeastDistanceOfComponents(result.Surface), 0.01);
  EXPECT_FALSE(Decimate(Icosphere(2, 3.0), options).Report.FragmentGapMeasured);
}

namespace
{
class EachIntersectionGuard : public EachShape
{
};
}

TEST_P(EachIntersectionGuard, HasNoMorePairsThatIntersectThanBefore)
{
  const Surface& input = GetParam().Surface;
  const std::int64_t before = CountCrossings(input);
  for (const auto& [mode, error] : { std::pair(Mode::Fast, 0.8), std::pair(Mode::Accurate, 0.1) })
  {
    const Surface result = Decimate(input, Guarded(mode, error)).Surface;
    EXPECT_LE(CountCrossings(result), before) << WordOf(mode) << " " << error;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachIntersectionGuard, testing::ValuesIn(AllShapes()), NameOf);

TEST(IntersectionGuard, NoRandomShapeGetsMorePairsThatIntersect)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (std::uint64_t round = 0; round < 12; ++round)
  {
    const Surface ball = BumpySphere(2, 5.0, 0.1 + 0.3 * uniform(random), round);
    const Surface input = Together(ball,
      Moved(BumpySphere(2, 3.0, 0.2, round + 100), Vector3(6.0 + 3.0 * uniform(random), 1.0, 0.5)));
    const double error = 0.05 + 1.5 * uniform(random);
    const Mode mode = ProvingModes()[round % ProvingModes().size()];
    const Surface result = Decimate(input, Guarded(mode, error)).Surface;
    EXPECT_LE(CountCrossings(result), CountCrossings(input)) << WordOf(mode) << " " << error;
    EXPECT_GE(LeastDistanceOfComponents(result), 0.5 * LeastDistanceOfComponents(input) - 1e-9)
      << WordOf(mode) << " " << error;
  }
}
