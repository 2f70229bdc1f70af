// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certificate/Certificate.h"
#include "Mesh/Statistics.h"
#include "Pieces/Junction.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bonedecimate::testsupport
{
namespace
{
Options JunctionOptions(double error)
{
  Options options;
  options.Mode = Mode::Fast;
  options.MaximumError = error;
  options.MeasureDistances = false;
  options.NumberOfThreads = 1;
  return options;
}

JunctionInput InMiddle(const Surface& original, const Surface& strip)
{
  JunctionInput junction;
  junction.Original.Shape = original;
  junction.Strip.Shape = strip;
  junction.EditZone = { Vector3::UnitX(), 3.5, 16.5 };
  junction.BoundaryZone = { Vector3::UnitX(), 2.5, 17.5 };
  junction.IsFinished.assign(strip.Points.size(), 0);
  return junction;
}

bool HasPoint(const Surface& surface, const Vector3& p)
{
  return std::find(surface.Points.begin(), surface.Points.end(), p) != surface.Points.end();
}

Surface RaisedAt(Surface surface, const Vector3& p, double height)
{
  *std::find(surface.Points.begin(), surface.Points.end(), p) += Vector3(0.0, 0.0, height);
  return surface;
}
}

TEST(Junction, ChangesNothingOutsideOfItsZone)
{
  const Surface strip = HeightField(20, 0.1, 5);
  const Surface result =
    DecimateJunction(InMiddle(strip, strip), JunctionOptions(0.3), nullptr, false, {}).Run.Surface;
  EXPECT_LT(result.Triangles.size(), strip.Triangles.size() / 2);
  for (const Vector3& p : strip.Points)
  {
    EXPECT_TRUE((p.x() > 3.5 && p.x() < 16.5) || HasPoint(result, p)) << p.transpose();
  }
  for (const Vector3& p : result.Points)
  {
    EXPECT_TRUE((p.x() > 3.5 && p.x() < 16.5) || HasPoint(strip, p)) << p.transpose();
  }
}

/// The strip is nearly as far from the original as the error allows: little is left of it, but edits refer to the original.
TEST(Junction, GivesEditsTheWholeErrorOfTheOriginal)
{
  const Surface original = HeightField(20, 0.2, 5);
  const Surface strip = HeightField(20, 0.2, 8);
  const JunctionResult junction =
    DecimateJunction(InMiddle(original, strip), JunctionOptions(0.45), nullptr, false, {});
  EXPECT_EQ(junction.Proof, ProofStatus::Proved);
  EXPECT_LE(junction.OriginalToResult.Upper, 0.45);
  EXPECT_LE(junction.ResultToOriginal.Upper, 0.45);
  EXPECT_GT(junction.OriginalToResult.Upper, 0.1);
  EXPECT_LT(junction.Run.Surface.Triangles.size(), strip.Triangles.size() / 2);
  CertificateOptions question;
  question.Tolerance = 0.45;
  EXPECT_EQ(Certify(original, junction.Run.Surface, question).Proof, ProofStatus::Proved);
}

TEST(Junction, LeavesAloneWhatItCannotProve)
{
  const Vector3 middle(10.0, 10.0, 0.0);
  const Surface strip = Grid(20);
  const Options options = JunctionOptions(0.3);
  EXPECT_FALSE(HasPoint(
    DecimateJunction(InMiddle(strip, strip), options, nullptr, false, {}).Run.Surface, middle));
  const JunctionResult junction =
    DecimateJunction(InMiddle(RaisedAt(strip, middle, 1.0), strip), options, nullptr, false, {});
  EXPECT_EQ(junction.Proof, ProofStatus::Violated); // as it was before
  for (const Vector3& step :
    { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(-1, 0, 0), Vector3(0, 1, 0), Vector3(0, -1, 0) })
  {
    EXPECT_TRUE(HasPoint(junction.Run.Surface, middle + step));
  }
  EXPECT_LT(junction.Run.Surface.Triangles.size(), strip.Triangles.size() * 2 / 3);
}

TEST(Junction, LeavesFinishedComponentsAlone)
{
  const Surface strip = Together(Grid(20), Moved(Grid(20), { 0.0, 0.0, 9.0 }));
  JunctionInput input = InMiddle(strip, strip);
  for (std::size_t i = 0; i < strip.Points.size(); ++i)
  {
    input.IsFinished[i] = strip.Points[i].z() > 5.0 ? 1 : 0;
  }
  const Surface result =
    DecimateJunction(input, JunctionOptions(0.3), nullptr, false, {}).Run.Surface;
  const auto count = std::count_if(result.Triangles.begin(), result.Triangles.end(),
    [&](const Triangle& c) { return result.Points[c[0]].z() > 5.0; });
  EXPECT_EQ(count, 800);
  EXPECT_LT(result.Triangles.size(), 1200u);
  EXPECT_EQ(Describe(result).Components, 2);
}
}
