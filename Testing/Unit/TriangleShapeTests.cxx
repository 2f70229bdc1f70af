// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The figures of triangle shapes, against angles from acos and shapes that are known.
#include "Geometry/SmallestAngle.h"
#include "Mesh/TriangleShapes.h"
#include "Run/Input/EdgeLengths.h"
#include "Run/Output/CompareShapes.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
Surface OneTriangle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  Surface surface;
  surface.Points = { a, b, c };
  surface.Triangles = { { 0, 1, 2 } };
  return surface;
}

const double Degree = std::acos(-1.0) / 180.0;

/// @param degrees The least angle, 0: none.  @param length Length of edges, mm; 0: none.
Report Compared(const Surface& surface, double degrees, double length)
{
  Options options;
  options.MinimumAngle = degrees;
  options.EdgeLength = length;
  Report report;
  CompareShapes(surface, options, ShapeLimitsOf(options), Vector3::Zero(), report);
  return report;
}
}

TEST(TriangleShapes, AnEquilateralTriangleHasRatiosOfOne)
{
  const ShapeStatistics found =
    DescribeShapes(OneTriangle({ 0, 0, 0 }, { 2, 0, 0 }, { 1, std::sqrt(3.0), 0 }), 1);
  EXPECT_NEAR(found.SmallestAngle, 60.0, 1e-6);
  EXPECT_NEAR(found.MaxAngle, 60.0, 1e-6);
  EXPECT_NEAR(found.MeanRadiusRatio, 1.0, 1e-12);
  EXPECT_NEAR(found.MeanAspectRatio, 1.0, 1e-12);
  EXPECT_EQ(found.MinAngles[5], 1);
}

TEST(TriangleShapes, ARightTriangleHasThoseOfTheTextbook)
{
  // Sides 3, 4, 5: inradius 1, circumradius 2.5.
  const ShapeStatistics found =
    DescribeShapes(OneTriangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 0, 3 }), 1);
  EXPECT_NEAR(found.SmallestAngle * Degree, std::atan(0.75), 1e-9);
  EXPECT_NEAR(found.MaxAngle, 90.0, 1e-6);
  EXPECT_NEAR(found.MaxRadiusRatio, 1.25, 1e-12);
  EXPECT_NEAR(found.MaxAspectRatio, 5.0 / (2.0 * std::sqrt(3.0)), 1e-12);
  EXPECT_EQ(found.MinAngles[3], 1);
}

TEST(TriangleShapes, TrianglesWithoutAreaCountAsOfAngleZeroOnly)
{
  const ShapeStatistics found =
    DescribeShapes(OneTriangle({ 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }), 1);
  EXPECT_EQ(found.MinAngles[0], 1);
  EXPECT_TRUE(std::isnan(found.SmallestAngle));
  EXPECT_TRUE(std::isnan(found.MeanRadiusRatio));
}

TEST(TriangleShapes, OfTwoSurfacesAreThoseOfBothTogether)
{
  const Surface one = BumpySphere(2, 10.0, 1.0, 3);
  const Surface other = Torus(12, 8);
  Surface both = one;
  const Index shift = static_cast<Index>(one.Points.size());
  both.Points.insert(both.Points.end(), other.Points.begin(), other.Points.end());
  for (const Triangle& v : other.Triangles)
  {
    both.Triangles.push_back({ v[0] + shift, v[1] + shift, v[2] + shift });
  }
  const ShapeStatistics expected = DescribeShapes(both, 2);
  ShapeStatistics sum;
  AddShapes(DescribeShapes(one, 1), sum);
  AddShapes(DescribeShapes(other, 1), sum);
  AddShapes(ShapeStatistics(), sum);
  EXPECT_EQ(sum.MinAngles, expected.MinAngles);
  EXPECT_EQ(sum.SmallestAngle, expected.SmallestAngle);
  EXPECT_EQ(sum.MaxAngle, expected.MaxAngle);
  EXPECT_EQ(sum.MaxRadiusRatio, expected.MaxRadiusRatio);
  EXPECT_EQ(sum.MaxAspectRatio, expected.MaxAspectRatio);
  EXPECT_NEAR(sum.MeanRadiusRatio, expected.MeanRadiusRatio, 1e-12);
  EXPECT_NEAR(sum.MeanAspectRatio, expected.MeanAspectRatio, 1e-12);
}

TEST(TriangleShapes, CosinesOfDegreesAreThoseOfTheLibrary)
{
  for (double degrees = 0.0; degrees <= 90.0; degrees += 0.5)
  {
    EXPECT_NEAR(CosineOfDegrees(degrees), std::cos(degrees * Degree), 1e-14) << degrees;
  }
}

TEST(TriangleShapes, TrianglesBelowAnAngleAreCountedAndTheWorstIsFound)
{
  Surface surface = OneTriangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 0, 3 }); // 36.9 degrees
  surface.Points.insert(surface.Points.end(), { { 9, 0, 0 }, { 10, 0, 0 }, { 9, 0.1, 0 } });
  surface.Triangles.push_back({ 3, 4, 5 }); // 5.7 degrees
  const auto below = [&surface](double degrees) { return Compared(surface, degrees, 0.0).Angles; };
  EXPECT_EQ(below(0.0).Below, 0);
  EXPECT_EQ(below(5.0).Below, 0);
  EXPECT_EQ(below(30.0).Below, 1);
  EXPECT_NEAR(below(30.0).Worst.x(), 28.0 / 3.0, 1e-12);
  EXPECT_EQ(below(37.0).Below, 2);
}

TEST(TriangleShapes, EdgesAreComparedWithALengthEachOnce)
{
  // A square of side 3 with its diagonal.
  Surface surface;
  surface.Points = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 } };
  surface.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  const auto edges = [&surface](double length) { return Compared(surface, 0.0, length).Edges; };
  const double diagonal = std::sqrt(18.0);
  EXPECT_NEAR(edges(3.0).Mean, (12.0 + diagonal) / 5.0, 1e-12);
  EXPECT_NEAR(edges(3.0).Longest, diagonal, 1e-12);
  EXPECT_EQ(edges(3.0).Longer, 1); // 4.24 is more than 4
  EXPECT_EQ(edges(3.0).Shorter, 0);
  EXPECT_EQ(edges(3.0).Worst, Vector3(1.5, 1.5, 0.0));
  EXPECT_EQ(edges(3.2).Longer, 0);
  EXPECT_EQ(edges(2.0).Longer, 5);
  EXPECT_EQ(edges(4.0).Shorter, 4); // 3 is less than 3.2
  EXPECT_EQ(edges(0.0).Longer, 0);
}
