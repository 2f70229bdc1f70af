// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Report/PairWarnings.h"

#include "Mesh/BoneSize.h"
#include "Run/Output/ComparedSurface.h"
#include "Run/Report/SizeText.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
Surface Ball(double radius, double x)
{
  return Moved(Icosphere(2, radius), { x, 0.0, 0.0 });
}

PairFigures Compare(const Surface& reference, const Surface& result)
{
  PairFigures figures;
  const std::vector<LeftOutShape> nothing;
  CertificateOptions options;
  options.NumberOfThreads = 2;
  CertifyPair({ reference, nothing }, { result, nothing }, options, true, {}, figures);
  return figures;
}

std::vector<std::string> Warnings(const Surface& reference, const Surface& result)
{
  return PairWarnings(Compare(reference, result));
}

using Sentences = std::vector<std::string>;
}

TEST(PairWarnings, FindMissingComponentsWhereTheirNumbersAgree)
{
  const Surface bones = Together(Together(Ball(20.0, 0.0), Ball(1.0, 24.0)), Ball(3.0, 60.0));
  const Surface half = Moved(Together(Ball(1.4, -2.0), Ball(1.4, 2.0)), { 60.0, 0.0, 0.0 });
  const PairFigures figures = Compare(bones, Together(Ball(19.9, 0.0), half));
  EXPECT_EQ(figures.Result->Surface.Components, figures.Reference->Surface.Components);
  ASSERT_EQ(figures.Missing.size(), 1U);
  EXPECT_EQ(figures.Missing[0].Triangles, 320);
  EXPECT_NEAR(figures.Missing[0].Center[0], 24.0, 1e-9);
  EXPECT_NEAR(figures.Missing[0].Diagonal, DiagonalOf(Ball(1.0, 0.0).Points), 1e-9);
  EXPECT_EQ(PairWarnings(figures)[0],
    "1 of 3 components of the reference is missing in the result: 320 triangles, 3.46 mm, at (24, "
    "0, 0)");
}

TEST(PairWarnings, NameTheLargestOfSeveralMissingComponents)
{
  const Surface bones = Together(Together(Ball(20.0, 0.0), Ball(1.0, 24.0)), Ball(3.0, 60.0));
  const Sentences found = Warnings(bones, Ball(20.0, 0.0));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].rfind("2 of 3 components of the reference are missing in the result: the "
                           "largest has 320 triangles, 10.4 mm, at (60, ",
              0),
    0U);
}

TEST(PairWarnings, AreNoneOfAResultThatHasAll)
{
  const Surface bones = Together(Ball(20.0, 0.0), Ball(1.0, 21.2));
  EXPECT_EQ(Warnings(bones, Together(Ball(19.9, 0.0), Ball(0.9, 21.2))), Sentences());
  EXPECT_EQ(Warnings(Ball(20.0, 0.0), Ball(5.0, 90.0)), Sentences()); // the only component
}

TEST(PairWarnings, NameAResultThatIsInsideOutCrossedOrTheSame)
{
  const Surface ball = Ball(20.0, 0.0);
  EXPECT_EQ(
    Warnings(ball, ball), Sentences({ "the reference and the result have the same triangles" }));
  EXPECT_EQ(Warnings(ball, TurnedInsideOut(ball)),
    Sentences({ "the result is inside out, compared with the reference" }));
  EXPECT_EQ(Warnings(TurnedInsideOut(ball), ball),
    Sentences({ "the reference is inside out, compared with the result" }));
  const Sentences crossed = Warnings(ball, Together(ball, Moved(ball, { 7.0, 0.0, 0.0 })));
  ASSERT_EQ(crossed.size(), 1U);
  EXPECT_NE(
    crossed[0].find(" intersecting pairs of triangles, the reference 0"), std::string::npos);
}

TEST(PairWarnings, NameSizesThatMayBeOfAnotherUnit)
{
  const Surface ball = Ball(20.0, 0.0);
  EXPECT_EQ(PairSizeWarnings(ball, ball, 17.0), Sentences());
  Surface unused = ball;
  unused.Points.emplace_back(1e6, 0.0, std::nan("")); // of no triangle
  EXPECT_EQ(PairSizeWarnings(unused, ball, 17.0), Sentences());
  EXPECT_EQ(PairSizeWarnings(ball, ball, 18.0),
    Sentences({ "the tolerance of 18 mm is more than a quarter of the diagonal of the reference's "
                "bounding box, 69.282 mm; the coordinates may not be in millimeters" }));
  const Surface meters = Ball(0.02, 0.0);
  EXPECT_EQ(PairSizeWarnings(meters, meters, 0.0),
    Sentences({ "the diagonal of the reference's bounding box is 0.069282 mm, which is not the "
                "size of a bone; the coordinates may not be in millimeters" }));
  EXPECT_EQ(PairSizeWarnings(ball, meters, 0.5),
    Sentences({ "the diagonal of the result is 0.001 times that of the reference: the surfaces may "
                "have different units" }));
}
