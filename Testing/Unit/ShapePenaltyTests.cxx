// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What narrow triangles cost where no angle is requested, against its formula, and what that does
// to the triangles of Balanced.
#include "Decimate/Cost/ShapePenalty.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// 4 sqrt(3) area / sum of squared sides, the area by Heron's formula.
double QualityOf(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double p = (b - a).norm();
  const double q = (c - b).norm();
  const double r = (a - c).norm();
  const double s = 0.5 * (p + q + r);
  const double square = s * (s - p) * (s - q) * (s - r);
  return 4.0 * std::sqrt(3.0 * std::max(0.0, square)) / (p * p + q * q + r * r);
}

double PenaltyOf(double weight, double quality)
{
  return weight / std::pow(quality + 0.02, 2.0);
}

struct Shapes
{
  double MeanQuality = 0.0;
  double Narrow = 0.0;   // fraction of the triangles below 0.2
  double Distance = 0.0; // mm, the mean to the input and from it, the larger
};

Shapes ShapesIn(Mode mode, const Surface& surface, Options options)
{
  options.MeasureDistances = true;
  const Result result = Decimate(surface, InMode(mode, options));
  Shapes shapes;
  const double count = static_cast<double>(result.Surface.Triangles.size());
  for (const Triangle& v : result.Surface.Triangles)
  {
    const auto& points = result.Surface.Points;
    const double quality = QualityOf(points[v[0]], points[v[1]], points[v[2]]);
    shapes.MeanQuality += quality / count;
    shapes.Narrow += quality < 0.2 ? 1.0 / count : 0.0;
  }
  shapes.Distance = std::max(result.Report.OutputToInput.Mean, result.Report.InputToOutput.Mean);
  return shapes;
}
}

TEST(ShapePenalty, IsTheSquareOfTheReciprocalOfTheQuality)
{
  const Vector3 a(1, 2, 3);
  const Vector3 b(4, 2, 3.5);
  for (const Vector3& c : { Vector3(2.5, 4.5, 3), Vector3(2.5, 2.3, 3.2), Vector3(-9, 2.1, 3) })
  {
    const double expected = PenaltyOf(1.5, QualityOf(a, b, c));
    EXPECT_NEAR(ShapePenalty(1.5).Of(TriangleFrame(a, b, c)), expected, 1e-12 * expected);
  }
  EXPECT_NEAR(ShapePenalty(1.5).Of(TriangleFrame(a, b, b)), PenaltyOf(1.5, 0.0), 1e-9);
  EXPECT_EQ(ShapePenalty(1.5).Of(TriangleFrame(a, a, a)), 0.0);
  EXPECT_EQ(ShapePenalty(0.0).Of(TriangleFrame(a, b, b)), 0.0);
}

TEST(ShapePenalty, PullsAlongItsSlope)
{
  const Vector3 b(4, 2, 3.5);
  const Vector3 c(2.5, 4.5, 3);
  const ShapePenalty penalty(1.5);
  for (const Vector3& a : { Vector3(1, 2, 3), Vector3(3.2, 3.2, 3.1), Vector3(40, 2, 3) })
  {
    const ShapePenalty::Slope slope = penalty.At(TriangleFrame(a, b, c));
    for (Index k = 0; k < 3; ++k)
    {
      const Vector3 step = 1e-6 * Vector3::Unit(k);
      const double fall =
        penalty.Of(TriangleFrame(a - step, b, c)) - penalty.Of(TriangleFrame(a + step, b, c));
      EXPECT_NEAR(slope.Pull[k], 0.5 * fall / 2e-6, 1e-6 * slope.Pull.norm()) << k;
    }
    const Vector3 better = a + slope.Pull / slope.Stiffness;
    EXPECT_LT(penalty.Of(TriangleFrame(better, b, c)), penalty.Of(TriangleFrame(a, b, c)));
  }
}

TEST(ShapePenalty, HasTheSameBitsInUnitsThatDifferByAPowerOfTwo)
{
  const Vector3 a(1, 2, 3);
  const Vector3 b(4, 2, 3.5);
  const Vector3 c(2.5, 2.3, 3);
  EXPECT_EQ(ShapePenalty(1.5).Of(TriangleFrame(a, b, c)),
    ShapePenalty(1.5).Of(TriangleFrame(8.0 * a, 8.0 * b, 8.0 * c)));
}

TEST(ShapePenalty, LeavesFewNarrowTrianglesInBalancedForLittleDistance)
{
  const Surface surface = Torus(64, 48);
  const Shapes with = ShapesIn(Mode::Balanced, surface, Reduction(0.9));
  const Shapes without = ShapesIn(Mode::Accurate, surface, Reduction(0.9)); // it has none
  EXPECT_GT(with.MeanQuality, without.MeanQuality + 0.02);
  EXPECT_LT(with.Narrow, 0.3 * without.Narrow);
  EXPECT_LT(with.Distance, 1.1 * without.Distance);
}
