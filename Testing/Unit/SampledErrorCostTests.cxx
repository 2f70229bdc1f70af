// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The error by which the last collapses, flips and moves of Balanced and Accurate are ordered,
// against its formula.
#include "Decimate/Cost/SampledErrorCost.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;

namespace
{
constexpr double Unit = 0.5;                        // mm
constexpr Samples::Averages Usual = { 0.125, 2.0 }; // mm, squares of the unit

double ThreeHalvesOf(double distance)
{
  return std::pow(distance / Unit, 1.5);
}

/// far(d, k) of the header.
double FarOf(double distance, double times)
{
  const double limit = times * Usual.Distance;
  const double beyond = distance * distance / (limit * limit) - 1.0;
  return distance > limit ? Usual.FaceArea * ThreeHalvesOf(limit) * beyond * beyond : 0.0;
}
}

TEST(SampledErrorCost, IsTheAreaTimesTheDistanceToThreeHalvesAndAPenaltyOfWhatIsFar)
{
  const ErrorPenalty penalty(Unit, Usual);
  for (const double d : { 0.0, 0.01, 0.1, 0.6, 0.7, 0.9, 1.1, 5.0 })
  {
    const double sample = 3.0 * ThreeHalvesOf(d) + FarOf(d, 8.0);
    const double vertex = 3.0 * ThreeHalvesOf(d) + FarOf(d, 5.0);
    EXPECT_NEAR(penalty.OfSample(3.0, d * d), sample, 1e-12 * (1.0 + sample)) << d;
    EXPECT_NEAR(penalty.OfVertex(3.0, d * d), vertex, 1e-12 * (1.0 + vertex)) << d;
    EXPECT_EQ(penalty.FitOfSample(3.0, d * d).Value, penalty.OfSample(3.0, d * d)) << d;
    EXPECT_EQ(penalty.FitOfVertex(3.0, d * d).Value, penalty.OfVertex(3.0, d * d)) << d;
  }
}

TEST(SampledErrorCost, FitsWithTheWeightOfItsSlope)
{
  const ErrorPenalty penalty(Unit, Usual);
  for (const double d : { 0.01, 0.1, 0.5, 0.9, 2.0 })
  {
    const double h = 1e-6 * d;
    const double slope =
      (penalty.OfSample(3.0, (d + h) * (d + h)) - penalty.OfSample(3.0, (d - h) * (d - h))) /
      (2.0 * h);
    EXPECT_NEAR(2.0 * d * penalty.FitOfSample(3.0, d * d).Weight, slope, 1e-5 * slope) << d;
  }
}

TEST(SampledErrorCost, HasTheSameBitsInUnitsThatDifferByAPowerOfTwo)
{
  const ErrorPenalty penalty(Unit, Usual);
  const ErrorPenalty scaled(8.0 * Unit, { 8.0 * Usual.Distance, Usual.FaceArea });
  for (const double d : { 0.01, 0.1, 0.7, 0.9, 5.0 })
  {
    EXPECT_EQ(scaled.OfSample(3.0, 64.0 * d * d), penalty.OfSample(3.0, d * d)) << d;
    EXPECT_EQ(scaled.OfVertex(3.0, 64.0 * d * d), penalty.OfVertex(3.0, d * d)) << d;
    EXPECT_EQ(scaled.InUnits(64.0 * d), penalty.InUnits(d)) << d;
  }
}
