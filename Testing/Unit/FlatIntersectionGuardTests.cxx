// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The intersection guard where triangles lie in one plane, touch, or are very near: it neither hinders nor lets through.
#include "BruteForce.h"
#include "Crossings.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
Options Guarded(Mode mode, double error, bool hasGuard = true)
{
  Options options = InMode(mode, Error(error));
  options.IntersectionGuard = hasGuard;
  return options;
}
}

TEST(FlatIntersectionGuard, FlatPartsAreSimplifiedAsIfNothingWereNear)
{
  const std::vector<std::pair<Surface, std::size_t>> shapes = { { Scaled(Cube(12), 5.0), 12 },
    { Prism(6, 6, 9), 20 }, { CappedCylinder(24, 9), 92 }, { VoxelEllipsoid(), 0 },
    { LabeledPart(1), 0 }, { Grid(20), 2 } };
  for (const auto& [shape, expected] : shapes)
  {
    for (const Mode mode : { Mode::Fast, Mode::Balanced })
    {
      const double error = expected > 0 ? 1e-3 : 0.3;
      const Result with = Decimate(shape, Guarded(mode, error));
      const Result without = Decimate(shape, Guarded(mode, error, false));
      const std::size_t count = with.Surface.Triangles.size();
      EXPECT_LE(count, 1.03 * without.Surface.Triangles.size() + 4) << WordOf(mode) << expected;
      EXPECT_TRUE(expected == 0 || count == expected) << WordOf(mode) << count;
      EXPECT_EQ(CountCrossings(with.Surface), 0) << WordOf(mode) << expected;
      const std::size_t crossing = static_cast<std::size_t>(Rejection::Intersection);
      EXPECT_LE(with.Report.Rejections[crossing], 10) << WordOf(mode) << expected;
    }
  }
}

/// Two plates whose near sides lie in one plane, apart or overlapping there, and one that stands on the other.
TEST(FlatIntersectionGuard, CoplanarPartsStayApartOrTouchNoMore)
{
  const Surface plate = Scaled(FlatPlate(6), 0.5);
  for (const Vector3& offset : { Vector3(3.25, 0.0, 0.0), Vector3(1.3, 0.7, 0.5) })
  {
    for (const Mode mode : { Mode::Fast, Mode::Balanced })
    {
      const Surface input = Together(plate, Moved(plate, offset));
      const std::int64_t before = CountCrossings(input);
      const Surface result = Decimate(input, Guarded(mode, 0.2)).Surface;
      EXPECT_LE(CountCrossings(result), before) << WordOf(mode) << offset.transpose();
      EXPECT_GE(LeastDistanceOfComponents(result), before == 0 ? 0.125 : 0.0);
      EXPECT_EQ(SplitComponents(result).size(), 2U);
      EXPECT_LT(result.Triangles.size(), input.Triangles.size() / 2) << WordOf(mode);
    }
  }
}

TEST(FlatIntersectionGuard, NearWallsAreNotTriedOverAndOver)
{
  const Surface spheres = NearSpheres(3, 0.001);
  const Result result = Decimate(spheres, Guarded(Mode::Fast, 0.1));
  EXPECT_EQ(CountCrossings(result.Surface), 0);
  EXPECT_GE(LeastDistanceOfComponents(result.Surface), 0.5 * LeastDistanceOfComponents(spheres));
  const std::size_t crossing = static_cast<std::size_t>(Rejection::Intersection);
  EXPECT_LT(
    result.Report.Rejections[crossing], static_cast<std::int64_t>(30 * spheres.Triangles.size()));
}
