// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The certificate, which is independent of the proofs of a run, confirms that the largest error is
// kept.
#include "Mesh/Cleaning.h"
#include "Proof/Certificate/Certificate.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{

ProofStatus Evaluate(const Surface& input, const Surface& result, double error)
{
  CertificateOptions options;
  options.Tolerance = error;
  options.TightBounds = false;
  options.NumberOfThreads = 1;
  return Certify(input, result, options).Proof;
}

/// Without what is dropped before decimation begins.
Surface Cleaned(const Surface& input)
{
  CleanSurface clean = Clean(input, true);
  for (std::size_t p = 0; p < clean.Surface.Points.size(); ++p)
  {
    clean.Surface.Points[p] = input.Points[clean.InputPoint[p]]; // bit for bit
  }
  return clean.Surface;
}

/// A disc, slit from its rim to the middle: the ends of the slit on the rim are 1e-8 mm apart.
Surface SlitDisc(const Vector3& middle)
{
  constexpr Index corners = 64;
  constexpr double halfSlit = 5e-10; // radians
  constexpr double radius = 10.0;
  const double turn = 2.0 * std::acos(-1.0) - 2.0 * halfSlit;
  Surface disc;
  disc.Points.push_back(middle);
  for (Index i = 0; i < corners; ++i)
  {
    const double angle = halfSlit + turn * i / (corners - 1);
    disc.Points.push_back(
      middle + radius * Vector3(std::cos(angle), std::sin(angle), 0.1 * std::sin(3.0 * angle)));
    if (i > 0)
    {
      disc.Triangles.push_back({ 0, i, i + 1 });
    }
  }
  return disc;
}

class EachErrorBound : public EachShape
{
};
}

TEST_P(EachErrorBound, IsKeptWhateverTheShape)
{
  const Surface& input = GetParam().Surface;
  const Surface cleaned = Cleaned(input);
  for (const Mode mode : { Mode::Fast, Mode::Accurate })
  {
    for (const double error : { 0.05, 0.6 })
    {
      const Result result = Decimate(input, InMode(mode, ErrorOfAnySize(error)));
      EXPECT_EQ(Evaluate(cleaned, result.Surface, error), ProofStatus::Proved)
        << WordOf(mode) << " " << error;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachErrorBound, testing::ValuesIn(AllShapes()), NameOf);

TEST(ErrorBound, AllowsFewerTrianglesTheLargerTheErrorIs)
{
  const Surface input = Icosphere(5, 20.0);
  std::size_t before = input.Triangles.size();
  for (const double error : { 0.02, 0.2, 2.0 })
  {
    const std::size_t now =
      Decimate(input, InMode(Mode::Fast, Error(error))).Surface.Triangles.size();
    EXPECT_LT(2 * now, before) << error;
    before = now;
  }
}

TEST(ErrorBound, HoldsAfterRoundingToSinglePrecisionFarFromTheOrigin)
{
  Surface input = Icosphere(4, 20.0);
  for (Vector3& p : input.Points)
  {
    p += Vector3(5000.0, -3000.0, 700.0);
  }
  Options options = InMode(Mode::Balanced, Error(0.2));
  options.OutputPointsPrecision = PointsPrecision::Single;
  const Result result = Decimate(input, options);
  EXPECT_LT(result.Surface.Triangles.size(), input.Triangles.size() / 2);
  EXPECT_EQ(Evaluate(input, result.Surface, 0.2), ProofStatus::Proved);
}

TEST(ErrorBound, IsRejectedIfSinglePrecisionCannotKeepIt)
{
  const Surface bone = Moved(Icosphere(2, 10.0), Vector3(1.0 / 3, 2000.0, 1e5 / 7));
  const auto run = [&](double error, double tolerance, PointsPrecision precision)
  {
    Options options = InMode(Mode::Fast, Error(error));
    options.OutputPointsPrecision = precision;
    const std::vector<double> tolerances(bone.Points.size(), tolerance);
    return Decimate(bone, options, {}, { false, false, &tolerances }).Report;
  };
  const double beyond = 1e-4; // mm; half of what two single numbers lie apart out there is 5e-4
  const Report rejected = run(beyond, -1.0, PointsPrecision::Single);
  EXPECT_EQ(rejected.Status, InputStatus::RoundingTooCoarse);
  EXPECT_GT(rejected.Cleaning.CoarsePoints, 0);
  EXPECT_GT(rejected.Cleaning.MaxRounding, beyond);
  EXPECT_NE(InputMessage(rejected).find("double precision"), std::string::npos);
  EXPECT_EQ(run(0.1, 0.0, PointsPrecision::Single).Status, InputStatus::RoundingTooCoarse);
  for (const Report& kept : { run(0.1, -1.0, PointsPrecision::Single),
         run(beyond, 0.0, PointsPrecision::Double), run(beyond, -1.0, PointsPrecision::Double) })
  {
    EXPECT_EQ(kept.Status, InputStatus::Good);
    EXPECT_EQ(kept.Proof.Status, ProofStatus::Proved);
  }
}

TEST(ErrorBound, ClosesNoSlitThatIsNarrowerThanSinglePrecision)
{
  // The second slit ends at z = 0, from where the next single number would be lost in positions
  // relative to the local origin.
  for (const Vector3& middle : { Vector3(1000.0, 2000.0, 3000.0), Vector3(-10.0, 2000.0, 3000.0) })
  {
    Surface input = SlitDisc(middle);
    for (Vector3& p : input.Points)
    {
      p = Vector3(p[1], p[2], p[0]);
    }
    ASSERT_EQ(input.Points[1].cast<float>(), input.Points.back().cast<float>());
    for (const Mode mode : ProvingModes())
    {
      for (const Options& reach : { Error(0.05), Error(0.5) })
      {
        Options options = InMode(mode, reach);
        options.OutputPointsPrecision = PointsPrecision::Single;
        const Result result = Decimate(input, options);
        EXPECT_LT(result.Surface.Triangles.size(), input.Triangles.size());
        EXPECT_EQ(Evaluate(input, result.Surface, options.MaximumError), ProofStatus::Proved)
          << WordOf(mode) << middle.transpose();
      }
    }
  }
}

TEST(ErrorBound, IsRejectedIfSinglePrecisionMergesPoints)
{
  const Surface input = Moved(Icosphere(2, 1.0), Vector3(1e7, 0.0, 0.0)); // 1 mm is one step there
  Options options = InMode(Mode::Fast, Error(10.0));
  options.AllowLargeError = true;
  options.TargetNumberOfTriangles = static_cast<Index>(input.Triangles.size());
  options.OutputPointsPrecision = PointsPrecision::Single;
  const Result rejected = Decimate(input, options);
  EXPECT_EQ(rejected.Report.Status, InputStatus::RoundingTooCoarse);
  EXPECT_GT(rejected.Report.Cleaning.MeetingPoints, 0);
  EXPECT_GE(rejected.Report.Cleaning.FirstCoarsePoint, 0);
  EXPECT_TRUE(rejected.Surface.Triangles.empty());
  EXPECT_NE(InputMessage(rejected.Report).find("positions of others"), std::string::npos);
  options.OutputPointsPrecision = PointsPrecision::Double;
  EXPECT_EQ(Decimate(input, options).Report.Proof.Status, ProofStatus::Proved);
}

TEST(ErrorBound, GivesTheSameBytesForAnyNumberOfThreads)
{
  Surface input = Grid(140); // enough points for blocks, waves that are not all provable
  for (Vector3& p : input.Points)
  {
    p[2] += 0.8 * std::sin(0.31 * p[0]) * std::cos(0.23 * p[1]);
  }
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    Options options = InMode(mode, Triangles(34000)); // of 39,200
    options.MaximumError = 0.05;
    ExpectTheSameBytesForAnyNumberOfThreads(input, options);
  }
}

TEST(ErrorBound, StopsAtTheNumberOfTrianglesIfThatComesFirst)
{
  const Surface input = BumpySphere(5, 20.0, 0.05, 8);
  for (const Mode mode : ProvingModes())
  {
    Options options = InMode(mode, Triangles(8000));
    options.MaximumError = 0.5;
    const Result result = Decimate(input, options);
    EXPECT_EQ(result.Report.Stop, StopReason::TargetReached) << WordOf(mode);
    EXPECT_EQ(result.Surface.Triangles.size(), 8000U) << WordOf(mode);
    EXPECT_EQ(Evaluate(input, result.Surface, 0.5), ProofStatus::Proved) << WordOf(mode);
  }
}
