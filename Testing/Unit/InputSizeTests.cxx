// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Input/InputSize.h"

#include "Options/OptionTable.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/ErrorSearch.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Its bounding box is a cube of 20 mm.
Surface Ball()
{
  return Icosphere(2, 10.0);
}

double DiagonalOf(const Surface& surface)
{
  Vector3 least = surface.Points.front();
  Vector3 most = least;
  for (const Vector3& p : surface.Points)
  {
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  return (most - least).norm();
}

int Count(const std::vector<std::string>& sentences, const std::string& text)
{
  return static_cast<int>(std::count_if(sentences.begin(), sentences.end(),
    [&](const std::string& one) { return one.find(text) != std::string::npos; }));
}
}

TEST(InputSize, RejectsErrorsAboveAQuarterOfTheDiagonalInEveryMode)
{
  const double quarter = 0.25 * DiagonalOf(Ball());
  for (const Mode mode : AllModes())
  {
    const Result rejected = Decimate(Ball(), InMode(mode, Error(quarter * 1.0001)));
    EXPECT_EQ(rejected.Report.Status, InputStatus::ErrorBeyondSize);
    EXPECT_TRUE(rejected.Surface.Triangles.empty());
    EXPECT_EQ(rejected.Report.Stop, StopReason::NotRun);
    EXPECT_EQ(
      Decimate(Ball(), InMode(mode, Error(quarter * 0.9999))).Report.Status, InputStatus::Good);
  }
}

TEST(InputSize, TheMessageNamesErrorDiagonalAndUnit)
{
  const Report rejected = Decimate(Scaled(Ball(), 0.001), Error(0.5)).Report; // a ball in meters
  const std::string message = InputMessage(rejected);
  EXPECT_NE(message.find("0.5 mm"), std::string::npos) << message;
  EXPECT_NE(message.find("0.034"), std::string::npos) << message;
  EXPECT_NE(message.find("may not be in millimeters"), std::string::npos) << message;
  EXPECT_NE(message.find("AllowLargeError"), std::string::npos) << message;
}

TEST(InputSize, AllowedErrorsBeyondTheDiagonalCountAsTheDiagonalAndTheReportSaysSo)
{
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    for (const double error : { 1e3, 1e29, 1e30 })
    {
      Options options = InMode(mode, Error(error));
      options.AllowLargeError = true;
      const Report report = Decimate(Ball(), options).Report;
      ASSERT_EQ(report.Status, InputStatus::Good) << error;
      EXPECT_EQ(report.Size.MaxError, error);
      EXPECT_NEAR(report.Size.ErrorBound, DiagonalOf(Ball()), 1e-9);
      EXPECT_EQ(report.Proof.Tolerance, report.Size.ErrorBound);
      EXPECT_EQ(report.Proof.Status, ProofStatus::Proved);
      EXPECT_EQ(Count(InputWarnings(report), "was used"), 1) << error;
    }
  }
}

TEST(InputSize, RejectsErrorsBelowAMillionthOfTheDiagonalIfTheyHaveToBeProved)
{
  const double millionth = 1e-6 * DiagonalOf(Ball());
  for (const Mode mode : ProvingModes())
  {
    const Report rejected = Decimate(Ball(), InMode(mode, Error(millionth * 0.999))).Report;
    EXPECT_EQ(rejected.Status, InputStatus::ErrorBelowSize);
    EXPECT_NE(InputMessage(rejected).find("less than a millionth"), std::string::npos);
    const double above = millionth * 1.001;
    EXPECT_EQ(CheckSize({ DiagonalOf(Ball()), above, -1, above }, InMode(mode, Error(above))),
      InputStatus::Good);
  }
  EXPECT_EQ(Decimate(Ball(), InMode(Mode::Thesis, Error(1e-9))).Report.Status, InputStatus::Good);
}

TEST(InputSize, PresetsAreLargestErrorsToo)
{
  Options options = InMode(Mode::Fast, Unmeasured());
  options.ErrorPreset = ErrorPreset::OneVoxel;
  options.VoxelSize = 20.0;
  EXPECT_EQ(Decimate(Ball(), options).Report.Status, InputStatus::ErrorBeyondSize);
  options.VoxelSize = 0.5;
  EXPECT_EQ(Decimate(Ball(), options).Report.Status, InputStatus::Good);
}

TEST(InputSize, TheLargestToleranceCountsOnlyIfItBinds)
{
  std::vector<double> tolerances(Ball().Points.size(), 0.5);
  tolerances[7] = 1e29;
  const auto run = [&](const Options& options) {
    return Decimate(Ball(), InMode(Mode::Fast, options), {}, { false, false, &tolerances }).Report;
  };
  const Report rejected = run(Unmeasured());
  EXPECT_EQ(rejected.Status, InputStatus::ErrorBeyondSize);
  EXPECT_NE(InputMessage(rejected).find("of point 7"), std::string::npos) << InputMessage(rejected);
  EXPECT_EQ(run(Error(0.5)).Status, InputStatus::Good) << "the largest error caps it";
  Options allowed = Unmeasured();
  allowed.AllowLargeError = true;
  const Report report = run(allowed);
  EXPECT_EQ(report.Status, InputStatus::Good);
  EXPECT_EQ(report.Proof.Status, ProofStatus::Proved);
  EXPECT_EQ(Count(InputWarnings(report), "point 7"), 1);
  tolerances[7] = -1.0;
  EXPECT_EQ(run(Unmeasured()).Status, InputStatus::Good) << "no limit of its own";
}

TEST(InputSize, EveryRunWarnsOfASizeThatIsNotThatOfABone)
{
  const Options options = InMode(Mode::Fast, Reduction(0.5));
  for (const double factor : { 0.001, 1000.0 })
  {
    const Report report = Decimate(Scaled(Ball(), factor), options).Report;
    EXPECT_EQ(Count(InputWarnings(report), "not the size of a bone"), 1) << factor;
    EXPECT_NEAR(report.Size.Diagonal, factor * DiagonalOf(Ball()), 1e-6 * factor);
  }
  EXPECT_TRUE(InputWarnings(Decimate(Ball(), options).Report).empty());
}

TEST(InputSize, SearchesTryErrorsOfAnySizeAndCurvesNone)
{
  ErrorSearchOptions options;
  options.Run = InMode(Mode::Fast, Triangles(4)); // the ball becomes a tetrahedron
  const ErrorSearchResult found = FindSmallestError(Ball(), options);
  ASSERT_GE(found.Best, 0);
  EXPECT_EQ(found.Found.Report.Status, InputStatus::Good);
  const ErrorSearchResult curve = FindErrorCurve(Ball(), { 0.5, 100.0, 1.0 }, options);
  EXPECT_EQ(curve.Found.Report.Status, InputStatus::ErrorBeyondSize);
  EXPECT_NE(InputMessage(curve.Found.Report).find("100 mm"), std::string::npos);
  options.Run.AllowLargeError = true;
  const ErrorSearchResult allowed = FindErrorCurve(Ball(), { 0.5, 100.0, 1.0 }, options);
  EXPECT_EQ(allowed.Trials.size(), 3U);
  EXPECT_EQ(allowed.Found.Report.Status, InputStatus::Good);
}

TEST(Options, OutsideOfTheirRangeAreRejectedByTheRun)
{
  const Surface ball = Icosphere(1, 10.0);
  Options options;
  EXPECT_EQ(CheckOptions(options), "");
  options.MaximumError = std::nan("");
  const Result rejected = Decimate(ball, options);
  EXPECT_EQ(rejected.Report.Status, InputStatus::InvalidOption);
  EXPECT_EQ(InputMessage(rejected.Report), CheckOptions(options));
  EXPECT_NE(CheckOptions(options).find("MaximumError takes a number from 0"), std::string::npos);
  EXPECT_TRUE(rejected.Surface.Triangles.empty());
  options = {};
  options.Mode = static_cast<Mode>(7);
  EXPECT_EQ(Decimate(ball, options).Report.Status, InputStatus::InvalidOption);
}
