// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Statistics.h"
#include "Partition/Slabs/ZoneRun.h"
#include "Proof/Certificate/Certificate.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bonedecimate::testsupport
{
namespace
{
Options ZoneOptions(double error)
{
  return InMode(Mode::Fast, Error(error));
}

ZoneInput InMiddle(const Surface& original, const Surface& strip)
{
  ZoneInput zone;
  zone.Original.Shape = original;
  zone.Strip.Shape = strip;
  zone.EditZone = { Vector3::UnitX(), 3.5, 16.5 };
  zone.BoundaryZone = { Vector3::UnitX(), 2.5, 17.5 };
  zone.IsFinished.assign(strip.Points.size(), 0);
  return zone;
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

TEST(ZoneRun, ChangesNothingOutsideOfItsZone)
{
  const Surface strip = HeightField(20, 0.1, 5);
  const Surface result =
    DecimateZone(InMiddle(strip, strip), ZoneOptions(0.3), nullptr, false, {}).Run.Surface;
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

/// The strip is nearly as far from the original as the error allows: little is left of it, but
/// edits refer to the original.
TEST(ZoneRun, GivesEditsTheWholeErrorOfTheOriginal)
{
  const Surface original = HeightField(20, 0.2, 5);
  const Surface strip = HeightField(20, 0.2, 8);
  const ZoneResult zone =
    DecimateZone(InMiddle(original, strip), ZoneOptions(0.45), nullptr, false, {});
  EXPECT_EQ(zone.Proof, ProofStatus::Proved);
  EXPECT_LE(zone.OriginalToResult.Upper, 0.45);
  EXPECT_LE(zone.ResultToOriginal.Upper, 0.45);
  EXPECT_GT(zone.OriginalToResult.Upper, 0.1);
  EXPECT_LT(zone.Run.Surface.Triangles.size(), strip.Triangles.size() / 2);
  CertificateOptions question;
  question.Tolerance = 0.45;
  EXPECT_EQ(Certify(original, zone.Run.Surface, question).Proof, ProofStatus::Proved);
}

TEST(ZoneRun, LeavesAloneWhatItCannotProve)
{
  const Vector3 middle(10.0, 10.0, 0.0);
  const Surface strip = Grid(20);
  const Options options = ZoneOptions(0.3);
  EXPECT_FALSE(HasPoint(
    DecimateZone(InMiddle(strip, strip), options, nullptr, false, {}).Run.Surface, middle));
  const ZoneResult zone =
    DecimateZone(InMiddle(RaisedAt(strip, middle, 1.0), strip), options, nullptr, false, {});
  EXPECT_EQ(zone.Proof, ProofStatus::Violated); // as it was before
  for (const Vector3& step :
    { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(-1, 0, 0), Vector3(0, 1, 0), Vector3(0, -1, 0) })
  {
    EXPECT_TRUE(HasPoint(zone.Run.Surface, middle + step));
  }
  EXPECT_LT(zone.Run.Surface.Triangles.size(), strip.Triangles.size() * 2 / 3);
}

TEST(ZoneRun, LeavesFinishedComponentsAlone)
{
  const Surface strip = Together(Grid(20), Moved(Grid(20), { 0.0, 0.0, 9.0 }));
  ZoneInput input = InMiddle(strip, strip);
  for (std::size_t i = 0; i < strip.Points.size(); ++i)
  {
    input.IsFinished[i] = strip.Points[i].z() > 5.0 ? 1 : 0;
  }
  const Surface result = DecimateZone(input, ZoneOptions(0.3), nullptr, false, {}).Run.Surface;
  const auto count = std::count_if(result.Triangles.begin(), result.Triangles.end(),
    [&](const Triangle& c) { return result.Points[c[0]].z() > 5.0; });
  EXPECT_EQ(count, 800);
  EXPECT_LT(result.Triangles.size(), 1200u);
  EXPECT_EQ(Describe(result).Components, 2);
}
}
