// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Certificates of surfaces as they were read.
#include "Run/Output/ComparedSurface.h"

#include "Shapes.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
struct Compared
{
  Certificate Found;
  PairFigures Figures;
};

Compared Compare(const Surface& reference, const Surface& result)
{
  const std::vector<LeftOutShape> nothing;
  CertificateOptions options;
  options.Tolerance = 0.5;
  Compared compared;
  compared.Found =
    CertifyPair({ reference, nothing }, { result, nothing }, options, false, {}, compared.Figures);
  return compared;
}

/// A ball and a spike beside it, 30 mm from the ball; the spike may be without area.
Surface BallAndSpike(bool hasArea)
{
  Surface surface = Icosphere(2, 10.0);
  const auto first = static_cast<Index>(surface.Points.size());
  surface.Points.insert(surface.Points.end(), { { 12.0, 0.0, 0.0 }, { 40.0, 0.0, 0.0 } });
  surface.Points.emplace_back(12.0, 1.0, 0.0);
  surface.Triangles.insert(
    surface.Triangles.begin(), { first, first + 1, hasArea ? first + 2 : first });
  return surface;
}
}

TEST(ComparedSurface, ASurfaceIsNotWhereOnlyATriangleWithoutAreaIs)
{
  const Compared compared = Compare(BallAndSpike(true), BallAndSpike(false));
  EXPECT_EQ(compared.Found.Proof, ProofStatus::Violated);
  EXPECT_NEAR(compared.Found.Upper(), 30.0, 0.1);
  EXPECT_EQ(compared.Found.ReferenceToResult.Distance.Triangle, 0);
  EXPECT_GT(compared.Found.ReferenceToResult.Distance.NearestTriangle, 0);
  ASSERT_EQ(compared.Figures.LeftOut.size(), 1U);
  EXPECT_EQ(compared.Figures.LeftOut[0].Sentence(),
    "1 triangle without area of the result, up to 0.000000 mm away");
}

TEST(ComparedSurface, ListsTrianglesWithoutAreaOfTheReferenceWithTheirDistance)
{
  const Compared compared = Compare(BallAndSpike(false), Icosphere(2, 10.0));
  EXPECT_EQ(compared.Found.Proof, ProofStatus::Proved);
  EXPECT_GT(compared.Found.ReferenceToResult.Distance.Triangle, 0); // numbered as in the whole
  ASSERT_EQ(compared.Figures.LeftOut.size(), 1U);
  EXPECT_NEAR(compared.Figures.LeftOut[0].Distance, 30.0, 0.1);
}

TEST(ComparedSurface, ATriangleWithoutAreaThatConnectsOthersIsComparedAsNoBoundaryOpens)
{
  // A square of two triangles and, along their common side, one without area.
  Surface square;
  square.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 1, 1, 0 } };
  square.Triangles = { { 0, 1, 2 }, { 0, 2, 4 }, { 0, 4, 3 }, { 4, 2, 3 } };
  Surface plain = square;
  plain.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  const Compared compared = Compare(square, plain);
  EXPECT_EQ(compared.Found.Proof, ProofStatus::Proved);
  EXPECT_NEAR(compared.Found.BoundaryOfReferenceToResult.Distance.Upper, 0.0, 1e-6);
  EXPECT_TRUE(compared.Figures.LeftOut.empty());
}

TEST(ComparedSurface, WithoutATriangleWithAreaThereIsNoSurface)
{
  Surface needle;
  needle.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  needle.Triangles = { { 0, 1, 2 } };
  EXPECT_EQ(Compare(needle, Icosphere(1, 1.0)).Found.Status, CertificateStatus::EmptyReference);
  EXPECT_EQ(Compare(Icosphere(1, 1.0), needle).Found.Proof, ProofStatus::Violated);
}
