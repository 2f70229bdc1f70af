// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// A largest error is kept, by the judgement of the certificate, which knows nothing of how it was proved.
#include "Certificate/Certificate.h"
#include "Guarantee/PieceCover.h"
#include "Guarantee/PlaneCover.h"
#include "Guarantee/ShareProof.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
const std::vector<Mode> ProvingModes = { Mode::Fast, Mode::Balanced, Mode::Accurate };

CertificateVerdict Judge(const Surface& input, const Surface& result, double error)
{
  CertificateOptions options;
  options.Tolerance = error;
  options.TightBounds = false;
  options.NumberOfThreads = 1;
  return Certify(input, result, options).Verdict;
}

/// Without what is dropped before decimation begins.
Surface Cleaned(const Surface& input)
{
  CleanSurface clean = Clean(input, true);
  for (Vector3& p : clean.Surface.Points)
  {
    p += clean.Origin;
  }
  return clean.Surface;
}

class EachGuarantee : public EachShape
{
};
}

TEST_P(EachGuarantee, IsKeptWhateverTheShape)
{
  const Surface& input = GetParam().Surface;
  const Surface cleaned = Cleaned(input);
  for (const Mode mode : ProvingModes)
  {
    for (const double error : { 0.01, 0.05, 0.6, 5.0 })
    {
      const Result result = Decimate(input, InMode(mode, Error(error)));
      EXPECT_EQ(Judge(cleaned, result.Surface, error), CertificateVerdict::Proved)
        << WordOf(mode) << " " << error;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachGuarantee, testing::ValuesIn(AllShapes()), NameOf);

TEST(Guarantee, AllowsFewerTrianglesTheLargerTheErrorIs)
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

TEST(Guarantee, HoldsAfterRoundingToSinglePrecisionFarFromTheOrigin)
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
  EXPECT_EQ(Judge(input, result.Surface, 0.2), CertificateVerdict::Proved);
}

TEST(Guarantee, GivesTheSameBytesForAnyNumberOfThreads)
{
  Surface input = Grid(140); // enough points for blocks, waves that are not all provable
  for (Vector3& p : input.Points)
  {
    p[2] += 0.8 * std::sin(0.31 * p[0]) * std::cos(0.23 * p[1]);
  }
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    Options options = InMode(mode, Triangles(28000)); // of 39,200
    options.MaximumError = 0.05;
    ExpectTheSameBytesForAnyNumberOfThreads(input, options);
  }
}

TEST(Guarantee, StopsAtTheNumberOfTrianglesIfThatComesFirst)
{
  const Surface input = BumpySphere(5, 20.0, 0.05, 8);
  for (const Mode mode : ProvingModes)
  {
    Options options = InMode(mode, Triangles(8000));
    options.MaximumError = 0.5;
    const Result result = Decimate(input, options);
    EXPECT_EQ(result.Report.Stop, StopReason::TargetReached) << WordOf(mode);
    EXPECT_EQ(result.Surface.Triangles.size(), 8000U) << WordOf(mode);
    EXPECT_EQ(Judge(input, result.Surface, 0.5), CertificateVerdict::Proved) << WordOf(mode);
  }
}

namespace
{
/// A triangle of random size near the origin.
std::array<Vector3, 3> AnyTriangle(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  std::array<Vector3, 3> triangle;
  for (Vector3& corner : triangle)
  {
    corner = Vector3(uniform(random), uniform(random), 0.3 * uniform(random));
  }
  return triangle;
}

Vector3 AnyPlace(std::mt19937& random, const std::array<Vector3, 3>& triangle)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double b = uniform(random);
  double c = uniform(random);
  if (b + c > 1.0)
  {
    b = 1.0 - b;
    c = 1.0 - c;
  }
  return triangle[0] + b * (triangle[1] - triangle[0]) + c * (triangle[2] - triangle[0]);
}
}

TEST(ShareProof, ProvesNothingThatIsNotSo)
{
  std::mt19937 random(7);
  int proved = 0;
  for (int round = 0; round < 2000; ++round)
  {
    Surface candidates;
    ShareProof proof;
    for (Index i = 0; i < 4; ++i)
    {
      const std::array<Vector3, 3> triangle = AnyTriangle(random, 2.0);
      proof.AddCandidate(triangle);
      candidates.Points.insert(candidates.Points.end(), triangle.begin(), triangle.end());
      candidates.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    }
    const std::array<Vector3, 3> triangle = AnyTriangle(random, 1.0);
    const double limit = 0.6;
    ShareProof::Piece whole;
    for (std::size_t k = 0; k < 3; ++k)
    {
      whole[k] = { triangle[k], limit, proof.FacesNear(triangle[k], limit) };
    }
    ShareProof::Faces used = 0;
    if (proof.Prove(whole, used))
    {
      ++proved;
      for (int i = 0; i < 50; ++i)
      {
        const Vector3 p = AnyPlace(random, triangle);
        EXPECT_LE(BruteNearest(candidates, p).Distance, limit * (1.0 + 1e-12));
      }
    }
  }
  EXPECT_GT(proved, 200);
}

TEST(PlaneCover, ProvesNothingThatIsNotSo)
{
  const Surface surface = BumpySphere(3, 5.0, 0.2, 7);
  const HalfEdgeMesh mesh(surface);
  PlaneCover cover(mesh);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int proved = 0;
  for (int round = 0; round < 3000; ++round)
  {
    const Index seed = static_cast<Index>(random() % surface.Triangles.size());
    const Vector3 middle = surface.Points[surface.Triangles[seed][0]];
    std::array<Vector3, 3> face;
    for (Vector3& corner : face)
    {
      corner = middle + Vector3(uniform(random), uniform(random), uniform(random));
    }
    const double limit = 0.7;
    if (cover.Prove(face, seed, [limit](Index) { return limit; }))
    {
      ++proved;
      for (int i = 0; i < 50; ++i)
      {
        EXPECT_LE(BruteNearest(surface, AnyPlace(random, face)).Distance, limit * (1.0 + 1e-12));
      }
    }
  }
  EXPECT_GT(proved, 50);
}
