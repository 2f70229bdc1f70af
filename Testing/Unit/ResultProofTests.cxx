// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The certificate of a run and the bounds at points, compared with the distances of single points.
#include "Proof/Certificate/Certificate.h"
#include "Run/Output/ResultProof.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Rounding = 1e-9; // mm, of the brute force

Result Proved(const Surface& input, Options options)
{
  options.MeasureInputDistances = true;
  return Decimate(input, options);
}

Vector3 AnyPoint(std::mt19937& random, const Surface& surface, const Triangle& triangle)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double b = uniform(random);
  double c = uniform(random);
  if (b + c > 1.0)
  {
    b = 1.0 - b;
    c = 1.0 - c;
  }
  const Vector3& first = surface.Points[triangle[0]];
  return first + b * (surface.Points[triangle[1]] - first) +
    c * (surface.Points[triangle[2]] - first);
}

/// No point of a triangle is farther than the bound at each of its corners.
void ExpectBounds(const Surface& surface, const std::vector<double>& bounds, const Surface& other)
{
  std::mt19937 random(5);
  ASSERT_EQ(bounds.size(), surface.Points.size());
  const std::size_t step = 1 + surface.Triangles.size() / 150;
  for (std::size_t t = 0; t < surface.Triangles.size(); t += step)
  {
    const Triangle& corners = surface.Triangles[t];
    const double bound = std::min({ bounds[corners[0]], bounds[corners[1]], bounds[corners[2]] });
    for (int i = 0; i < 6; ++i)
    {
      const Vector3 position = AnyPoint(random, surface, corners);
      EXPECT_LE(BruteNearest(other, position).Distance, bound + Rounding) << "triangle " << t;
    }
  }
}

double Largest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

/// The proof of a result that was changed after the run.
ErrorProof ProofOfAnother(const Surface& input, const Options& options, Result changed)
{
  changed.Report.Proof = {};
  ProveResult(input, Clean(input, true), options, {}, changed);
  return changed.Report.Proof;
}

class EachProof : public EachShape
{
};
}

TEST_P(EachProof, HoldsAndItsBoundsHoldAtEveryPoint)
{
  const Surface& input = GetParam().Surface;
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    const Result result = Proved(input, InMode(mode, ErrorOfAnySize(0.4)));
    const ErrorProof& proof = result.Report.Proof;
    ASSERT_TRUE(proof.WasMade) << WordOf(mode);
    EXPECT_EQ(proof.Status, ProofStatus::Proved) << WordOf(mode);
    EXPECT_LE(proof.Lower(), proof.Upper()) << WordOf(mode);
    EXPECT_LE(proof.Upper(), 0.4) << WordOf(mode);
    EXPECT_EQ(ProofMessage(result.Report), "") << WordOf(mode);
    ExpectBounds(result.Surface, result.ErrorBound, input);
    EXPECT_LE(Largest(result.ErrorBound), proof.OutputToInput.Upper) << WordOf(mode);
    EXPECT_GE(Largest(result.ErrorBound), proof.OutputToInput.Lower) << WordOf(mode);
    if (result.Report.LeftOut.empty())
    {
      ExpectBounds(input, result.InputErrorBound, result.Surface);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachProof, testing::ValuesIn(AllShapes()), NameOf);

TEST(ResultProof, IsTheCertificateOfTheTwoSurfaces)
{
  const Surface input = BumpySphere(4, 20.0, 0.1, 5);
  const Result result = Decimate(input, InMode(Mode::Balanced, Error(0.3)));
  const Certificate found = Certify(input, result.Surface);
  EXPECT_GT(result.Report.Proof.Upper(), 0.1);
  EXPECT_LE(result.Report.Proof.Lower(), found.Upper());
  EXPECT_GE(result.Report.Proof.Upper(), found.Lower());
  EXPECT_NEAR(result.Report.Proof.Upper(), found.Upper(), 1e-3 * found.Upper());
  EXPECT_GT(result.Report.Seconds.Prove, 0.0);
}

TEST(ResultProof, IsThatOfTheRoundedSurfaceFarFromTheOrigin)
{
  Surface input = Icosphere(3, 20.0);
  for (Vector3& p : input.Points)
  {
    p += Vector3(5000.0, -3000.0, 700.0);
  }
  Options options = InMode(Mode::Fast, Error(0.2));
  options.OutputPointsPrecision = PointsPrecision::Single;
  const Result result = Decimate(input, options);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  ExpectBounds(result.Surface, result.ErrorBound, input);
}

TEST(ResultProof, ContradictsAResultThatWasMoved)
{
  const Surface input = BumpySphere(3, 20.0, 0.1, 5);
  const Options options = InMode(Mode::Fast, Error(0.3));
  Result result = Decimate(input, options);
  EXPECT_EQ(ProofOfAnother(input, options, result).Status, ProofStatus::Proved);
  result.Surface.Points[3] *= 1.1;
  result.Report.Proof = ProofOfAnother(input, options, result);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Violated);
  EXPECT_NE(ProofMessage(result.Report).find("contradicts"), std::string::npos);
}

TEST(ResultProof, ContradictsAResultThatLostATriangleByItsBoundary)
{
  const Surface input = BumpySphere(3, 20.0, 0.1, 5);
  const Options options = InMode(Mode::Fast, Error(0.3));
  Result result = Decimate(input, options);
  result.Surface.Triangles.pop_back();
  EXPECT_EQ(ProofOfAnother(input, options, result).Status, ProofStatus::Violated);
}

TEST(ResultProof, HoldsTheResultToATolerancePerPoint)
{
  const Surface input = BumpySphere(3, 20.0, 0.1, 5);
  const Options options = InMode(Mode::Fast, Error(0.3));
  const CleanSurface cleaned = Clean(input, true);
  for (const auto& [tolerance, status] : { std::pair(0.3, ProofStatus::Proved),
         std::pair(-1.0, ProofStatus::Proved), std::pair(0.01, ProofStatus::Violated) })
  {
    Result result = Decimate(input, options);
    const std::vector<double> tolerances(input.Points.size(), tolerance);
    ProveResult(input, cleaned, options, {}, result, &tolerances);
    EXPECT_EQ(result.Report.Proof.Status, status) << tolerance;
  }
}

TEST(ResultProof, IsMadeOnlyWithAnErrorOrTolerances)
{
  const Surface input = BumpySphere(2, 20.0, 0.1, 5);
  Options off = Error(0.3);
  off.ProveResult = false;
  for (const Options& options :
    { Reduction(0.5), Triangles(100), InMode(Mode::Thesis, Error(0.3)), off })
  {
    const Result result = Decimate(input, options);
    EXPECT_FALSE(result.Report.Proof.WasMade);
    EXPECT_TRUE(result.ErrorBound.empty());
    EXPECT_TRUE(result.InputErrorBound.empty());
    EXPECT_EQ(result.Report.Seconds.Prove, 0.0);
  }
}

TEST(ResultProof, LeavesOutTrianglesWithoutAreaAndCountsThem)
{
  Surface input = BumpySphere(3, 20.0, 0.1, 5);
  const auto first = static_cast<Index>(input.Points.size());
  input.Points.insert(input.Points.end(), { { 90, 0, 0 }, { 91, 0, 0 }, { 92, 0, 0 } });
  input.Triangles.insert(input.Triangles.begin(), { first, first + 1, first + 2 });
  const Result result = Proved(input, InMode(Mode::Fast, Error(0.3)));
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  ASSERT_EQ(result.Report.LeftOut.size(), 1U);
  const LeftOut& leftOut = result.Report.LeftOut.front();
  EXPECT_EQ(leftOut.Kind, "triangles");
  EXPECT_EQ(leftOut.Count, 1);
  EXPECT_EQ(leftOut.Position(), "triangle 0");
  const double exact = BruteNearest(result.Surface, { 92, 0, 0 }).Distance;
  EXPECT_GE(leftOut.Distance, exact);
  EXPECT_LE(leftOut.Distance, 1.01 * exact);
  EXPECT_TRUE(std::isnan(result.InputErrorBound[first]));
  EXPECT_LE(result.InputErrorBound[0], 0.3);
}

TEST(ResultProof, DoesNotCompareBoundariesWithoutMergedPoints)
{
  Options options = InMode(Mode::Fast, Error(0.3));
  options.MergePoints = false;
  const Result result = Decimate(HoledPlate(9), options);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  EXPECT_FALSE(result.Report.Proof.BoundariesCompared);
}

TEST(ResultProof, GivesTheBoundariesToTheReport)
{
  Options options = InMode(Mode::Fast, Error(0.3));
  options.MeasureDistances = true;
  const Report report = Decimate(HoledPlate(9), options).Report;
  EXPECT_TRUE(report.BoundariesMeasured);
  EXPECT_EQ(report.BoundaryInputToOutput.Upper, report.Proof.BoundaryInputToOutput.Upper);
}

TEST(ResultProof, OfUnreadableSurfacesIsUndecidedWithoutBounds)
{
  const Surface input = BumpySphere(3, 20.0, 0.1, 5);
  const Options options = InMode(Mode::Fast, Error(0.3));
  Result broken = Decimate(input, options);
  broken.Surface.Points[3][1] = std::nan("");
  broken.Report.Proof = ProofOfAnother(input, options, broken);
  EXPECT_TRUE(broken.Report.Proof.WasMade);
  EXPECT_EQ(broken.Report.Proof.Status, ProofStatus::Undecided);
  EXPECT_TRUE(std::isinf(broken.Report.Proof.Upper()));
  EXPECT_FALSE(ProofMessage(broken.Report).empty());
}

TEST(ResultProof, IsMissingAfterAnAbort)
{
  const Surface input = BumpySphere(4, 20.0, 0.1, 5);
  Options options = InMode(Mode::Fast, Error(0.1));
  options.MeasureDistances = true;
  const std::size_t whole = Decimate(input, options).Surface.Triangles.size();
  for (const double stopAt : { 0.7, 0.905, 0.95, 0.985 })
  {
    const Result result =
      Decimate(input, options, [&](double fraction) { return fraction < stopAt; });
    EXPECT_EQ(result.Report.Stop, StopReason::Aborted) << stopAt;
    EXPECT_FALSE(result.Report.Proof.WasMade) << stopAt;
    EXPECT_TRUE(result.ErrorBound.empty()) << stopAt;
    EXPECT_EQ(result.Surface.Triangles.size(), whole) << stopAt;
  }
}

TEST(ResultProof, IsTheSameForAnyNumberOfThreads)
{
  const Surface input = BumpySphere(4, 20.0, 0.1, 5);
  Options options = InMode(Mode::Fast, Error(0.1));
  options.MeasureInputDistances = true;
  const Result one = Decimate(input, options);
  for (const int threads : { 2, 5 })
  {
    options.NumberOfThreads = threads;
    const Result more = Decimate(input, options);
    EXPECT_EQ(more.Report.Proof.Upper(), one.Report.Proof.Upper());
    EXPECT_EQ(more.ErrorBound, one.ErrorBound);
    EXPECT_EQ(more.InputErrorBound, one.InputErrorBound);
  }
}

TEST(ResultProof, BoundsOfTrianglesHaveTheRequestedGap)
{
  const Surface input = BumpySphere(3, 20.0, 0.1, 5);
  const Surface result = Decimate(input, InMode(Mode::Fast, Triangles(200))).Surface;
  CertificateOptions options;
  options.ResultTriangleGap = 0.01;
  const std::vector<double> bounds =
    Certify(input, result, options).ResultToReference.TriangleUpper;
  ASSERT_EQ(bounds.size(), result.Triangles.size());
  for (std::size_t t = 0; t < bounds.size(); t += 7)
  {
    const Surface alone = { result.Points, { result.Triangles[t] } };
    const DistanceBounds found = Certify(input, alone).ResultToReference.Distance;
    EXPECT_GE(bounds[t], found.Lower) << t;
    EXPECT_LE(bounds[t], found.Upper + 0.01 + Rounding) << t;
  }
}
