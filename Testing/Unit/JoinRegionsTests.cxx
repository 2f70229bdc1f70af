// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Errors of joining the results of regions to the rest are found.
#include "Crossings.h"
#include "Partition/Regions/JoinRegions.h"
#include "Partition/Regions/RegionCut.h"
#include "Partition/Regions/RegionMatch.h"
#include "Partition/Regions/RegionReport.h"
#include "Proof/Certificate/Certificate.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A sphere with a result for one region.
class JoinedRun : public testing::Test
{
protected:
  JoinedRun()
    : Input(Icosphere(4, 20.0))
    , Whole(PrepareWhole(this->Input, true, 1))
  {
    std::vector<double> tolerances;
    for (const Vector3& p : this->Input.Points)
    {
      tolerances.push_back(p[2] > 15.0 ? 0.2 : 0.0);
    }
    const std::vector<Region> regions =
      FindRegions(this->Whole.Cleaned.Surface, tolerances, 1.2, 1);
    this->Part = CutRegion(this->Input, this->Whole.Cleaned, regions.at(0), 1);
    RunInputs inputs = { false, true, &this->Part.Tolerances };
    this->Part.Result = Decimate(this->Part.Surface, InMode(Mode::Fast, Error(0.2)), {}, inputs);
    EXPECT_TRUE(MatchUnchanged(this->Part));
    this->Join();
  }

  void Join()
  {
    this->Parts = { std::make_shared<const RegionPart>(this->Part) };
    this->Joined = JoinRegions(this->Input, this->Whole, this->Parts, 1);
  }

  bool IsGood() const
  {
    return CheckJoined(this->Input, this->Whole, this->Parts, this->Joined, 1);
  }

  /// The first triangle of the part's result that is new or not.
  std::size_t First(bool isNew) const
  {
    std::size_t t = 0;
    while ((this->Part.OldTriangle[t] == None) != isNew)
    {
      ++t;
    }
    return t;
  }

  Surface Input;
  WholeSurface Whole;
  RegionPart Part;
  RegionParts Parts;
  JoinedRegions Joined;
};
}

TEST_F(JoinedRun, IsGood)
{
  EXPECT_TRUE(this->IsGood());
  EXPECT_LT(this->Joined.Surface.Triangles.size(), this->Input.Triangles.size());
}

TEST_F(JoinedRun, FindsAnUnchangedPointThatMoved)
{
  this->Joined.Surface.Points[3][1] += 1e-12;
  EXPECT_FALSE(this->IsGood());
}

TEST_F(JoinedRun, FindsATriangleThatIsMissingOrAdded)
{
  this->Joined.Surface.Triangles.push_back(this->Joined.Surface.Triangles.back());
  EXPECT_FALSE(this->IsGood());
  this->Joined.Surface.Triangles.resize(this->Joined.Surface.Triangles.size() - 2);
  EXPECT_FALSE(this->IsGood());
}

TEST_F(JoinedRun, FindsATriangleOfTheInputThatIsNowhere)
{
  this->Joined.Surface.Triangles.erase(this->Joined.Surface.Triangles.begin());
  this->Joined.UnchangedTriangle.erase(this->Joined.UnchangedTriangle.begin());
  EXPECT_FALSE(this->IsGood());
}

TEST_F(JoinedRun, FindsANewTriangleThatIsNotOfTheCertifiedResult)
{
  this->Part.Result.Surface.Points[this->Part.Result.Surface.Triangles[this->First(true)][0]] *=
    1.001;
  this->Parts = { std::make_shared<const RegionPart>(this->Part) };
  EXPECT_FALSE(this->IsGood());
}

TEST_F(JoinedRun, FindsACertifiedTriangleThatTheResultLacks)
{
  this->Part.OldTriangle[this->First(true)] = 0; // new, but taken for an unchanged one
  this->Join();
  EXPECT_FALSE(this->IsGood());
}

TEST_F(JoinedRun, FindsACertifiedInputThatIsNotTheInput)
{
  this->Part.Surface.Points[this->Part.Surface.Triangles[0][0]] *= 1.001;
  this->Parts = { std::make_shared<const RegionPart>(this->Part) };
  EXPECT_FALSE(this->IsGood());
}

TEST_F(JoinedRun, FindsAnIndexOutOfRange)
{
  this->Joined.Surface.Triangles[0][0] = static_cast<Index>(this->Joined.Surface.Points.size());
  EXPECT_FALSE(this->IsGood());
}

TEST_F(JoinedRun, DoesNotMatchAResultThatLacksAnUnchangedTriangle)
{
  this->Part.Result.Surface.Triangles.erase(
    this->Part.Result.Surface.Triangles.begin() + static_cast<std::ptrdiff_t>(this->First(false)));
  EXPECT_FALSE(MatchUnchanged(this->Part));
}

TEST_F(JoinedRun, NeedsTheProofOfItsParts)
{
  const std::map<Index, ExtentChange> none;
  EXPECT_TRUE(ArePartsValid(this->Whole, this->Parts, none, true));
  this->Part.Result.Report.Proof.Status = ProofStatus::Undecided;
  this->Join();
  EXPECT_FALSE(ArePartsValid(this->Whole, this->Parts, none, true));
  EXPECT_TRUE(ArePartsValid(this->Whole, this->Parts, none, false));
  this->Part.Result.Report.Proof.Status = ProofStatus::Proved;
  // farther than where the part was cut
  this->Part.Result.Report.Proof.BoundaryInputToOutput.Upper = 1.1;
  this->Join();
  EXPECT_FALSE(ArePartsValid(this->Whole, this->Parts, none, true));
}

TEST_F(JoinedRun, KeepsAQuarterOfTheVolumeOfAComponent)
{
  const double volume = this->Whole.Statistics.Volume;
  const auto isValid = [&](double ratio)
  {
    return ArePartsValid(
      this->Whole, this->Parts, { { 0, { 0.0, (ratio - 1.0) * volume } } }, true);
  };
  EXPECT_TRUE(isValid(0.26));
  EXPECT_FALSE(isValid(0.24));
  EXPECT_FALSE(isValid(-0.5));
}

TEST(RegionCut, SelectsEverythingWithinReach)
{
  const Surface input = Together(Icosphere(3, 20.0), Icosphere(3, 24.0));
  const WholeSurface whole = PrepareWhole(input, true, 1);
  std::vector<double> tolerances;
  for (const Vector3& p : input.Points)
  {
    tolerances.push_back(p[2] > 17.0 && p.norm() < 20.5 ? 0.2 : 0.0);
  }
  const Surface& clean = whole.Cleaned.Surface;
  for (const double reach : { 0.5, 5.0 })
  {
    const Region region = FindRegions(clean, tolerances, reach, 1).at(0);
    const RegionPart part = CutRegion(input, whole.Cleaned, region, 1);
    std::set<Triangle> changeable, selected;
    for (const Index t : region.Triangles)
    {
      changeable.insert(clean.Triangles[t]);
    }
    for (const Index t : part.Triangles)
    {
      selected.insert(clean.Triangles[t]);
    }
    EXPECT_LT(2 * selected.size(), input.Triangles.size());
    EXPECT_TRUE(
      std::includes(selected.begin(), selected.end(), changeable.begin(), changeable.end()));
    EXPECT_GT(LeastDistance(
                clean, [&](const Triangle& t) { return changeable.count(t) > 0; },
                [&](const Triangle& t) { return selected.count(t) == 0; }),
      reach);
    const bool hasOuter = std::any_of(part.Surface.Points.begin(), part.Surface.Points.end(),
      [](const Vector3& p) { return p.norm() > 20.5; });
    EXPECT_EQ(hasOuter, reach > 4.0);
  }
}
