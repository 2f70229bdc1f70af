// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Points of the output on a grid: the certificate confirms that the largest error is kept by what
// is written.
#include "Mesh/PointRounding.h"
#include "Proof/Certificate/Certificate.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Step = 1.0 / 64.0; // mm

Options OnGrid(Mode mode, double error, double step = Step)
{
  Options options = InMode(mode, Error(error));
  options.OutputPointsGrid = step;
  return options;
}

ProofStatus Evaluate(const Surface& input, const Surface& result, double error)
{
  CertificateOptions options;
  options.Tolerance = error;
  options.TightBounds = false;
  return Certify(input, result, options).Proof;
}

bool IsOnGrid(const Surface& surface, double step)
{
  for (const Vector3& p : surface.Points)
  {
    for (const double coordinate : p)
    {
      if (std::fmod(coordinate, step) != 0.0)
      {
        return false;
      }
    }
  }
  return true;
}

std::size_t CountPositions(const Surface& surface)
{
  std::set<std::array<double, 3>> positions;
  for (const Vector3& p : surface.Points)
  {
    positions.insert({ p[0], p[1], p[2] });
  }
  return positions.size();
}
}

TEST(PointRounding, TakesTheNearestMultipleOfTheStep)
{
  const PointRounding rounding = { false, 0.25 };
  EXPECT_EQ(rounding.Of(Vector3(0.13, -0.12, 7.0)), Vector3(0.25, 0.0, 7.0));
  EXPECT_EQ(PointRounding().Of(Vector3(0.13, 0.1, 0.2)), Vector3(0.13, 0.1, 0.2));
  const Vector3 origin(0.1, 0.2, 0.3);
  const Vector3 local = rounding.OfLocal(Vector3(0.4, 0.4, 0.4), origin);
  EXPECT_EQ(rounding.Of(local + origin), Vector3(0.5, 0.5, 0.75));
}

TEST(PointRounding, TheErrorIsProvedOfPointsOnTheGridInEveryMode)
{
  const Surface input = Moved(Icosphere(4, 20.0), Vector3(100.1, -30.2, 7.3));
  for (const Mode mode : ProvingModes())
  {
    const Result result = Decimate(input, OnGrid(mode, 0.2));
    EXPECT_TRUE(IsOnGrid(result.Surface, Step));
    EXPECT_LT(result.Surface.Triangles.size(), input.Triangles.size() / 2);
    EXPECT_EQ(CountPositions(result.Surface), result.Surface.Points.size());
    EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
    EXPECT_EQ(Evaluate(input, result.Surface, 0.2), ProofStatus::Proved);
  }
}

TEST(PointRounding, PointsThatTheGridWouldMergeAreKeptApart)
{
  // edges of 0.07 mm, not all longer than a diagonal of the grid
  const Surface input = Icosphere(4, 1.0);
  Options options = OnGrid(Mode::Fast, 0.2, 1.0 / 16.0);
  options.TargetNumberOfTriangles = static_cast<Index>(input.Triangles.size());
  const Result result = Decimate(input, options);
  if (result.Report.Status == InputStatus::Good)
  {
    EXPECT_EQ(CountPositions(result.Surface), result.Surface.Points.size());
  }
  else
  {
    EXPECT_EQ(result.Report.Status, InputStatus::RoundingTooCoarse);
    EXPECT_NE(InputMessage(result.Report).find("multiples of 0.0625 mm"), std::string::npos);
  }
}

TEST(PointRounding, AnErrorThatTheGridExceedsIsRejected)
{
  const Surface input = Moved(Icosphere(2, 10.0), Vector3(0.1, 0.2, 0.3));
  const Report report = Decimate(input, OnGrid(Mode::Fast, 0.1, 1.0)).Report;
  EXPECT_EQ(report.Status, InputStatus::RoundingTooCoarse);
  EXPECT_NE(InputMessage(report).find("a finer grid"), std::string::npos);
}

TEST(PointRounding, PointsOfToleranceZeroOffTheGridAreRejected)
{
  const Surface input = Moved(Icosphere(3, 10.0), Vector3(0.1, 0.2, 0.3));
  std::vector<double> tolerances(input.Points.size(), -1.0);
  tolerances[5] = 0.0;
  const auto run = [&](const Surface& surface)
  {
    return Decimate(surface, OnGrid(Mode::Fast, 0.2), {}, { false, false, &tolerances })
      .Report.Status;
  };
  EXPECT_EQ(run(input), InputStatus::RoundingTooCoarse);
  Surface onGrid = input;
  for (Vector3& p : onGrid.Points)
  {
    p = PointRounding{ false, Step }.Of(p);
  }
  EXPECT_EQ(run(onGrid), InputStatus::Good);
}
