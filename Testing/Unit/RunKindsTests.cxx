// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionTable.h"
#include "Options/RunKinds.h"

#include <gtest/gtest.h>

#include <set>

using namespace bonedecimate;

namespace
{
std::string Rejection(const std::string& kind, const Options& options)
{
  return FindUnsupported({ FindRunKind(kind) }, RequestsOf(options));
}
}

TEST(RunKinds, HaveDifferentNames)
{
  std::set<std::string> names;
  for (const RunKind& kind : RunKindTable())
  {
    EXPECT_TRUE(names.insert(kind.Name).second) << kind.Name;
  }
}

TEST(RunKinds, OfTheWholeSurfaceOfferEveryOption)
{
  for (const OptionInfo& info : OptionTable())
  {
    EXPECT_EQ(WhyUnsupported(FindRunKind("Whole"), info), "") << info.Name;
  }
}

TEST(RunKinds, RejectNoneOfTheDefaults)
{
  for (const RunKind& kind : RunKindTable())
  {
    EXPECT_EQ(FindUnsupported({ kind }, RequestsOf({})), "") << kind.Name;
  }
}

TEST(RunKinds, RejectWhatIsUsedAndNotWhatIsOff)
{
  Options options;
  options.Smoothing = 0.2;
  EXPECT_EQ(Rejection("Slabs", options), "A run in slabs does not smooth");
  options.Smoothing = 0.0;
  EXPECT_EQ(Rejection("Slabs", options), "");
  options.MergePoints = false;
  EXPECT_EQ(
    Rejection("Slabs", options), "A run in slabs merges points, because this joins the slabs");
}

TEST(RunKinds, TakeTheDefaultReductionForNone)
{
  Options options;
  EXPECT_EQ(Rejection("Slabs", options), "");
  options.TargetReductionIsExplicit = true; // and has the value of the default
  EXPECT_EQ(Rejection("Slabs", options),
    "A run in slabs does not know the whole surface, so it has no target number of triangles");
}

TEST(RunKinds, NeedVoxelsOnlyToKeepThem)
{
  Options options;
  options.KeepVoxels = KeepVoxels::Off;
  EXPECT_EQ(Rejection("RanksWithoutVoxelGrid", options), "");
  options.KeepVoxels = KeepVoxels::On;
  EXPECT_EQ(Rejection("RanksWithoutVoxelGrid", options),
    "KeepVoxels needs the voxel grid of the label map, and no process has one");
}

TEST(RunKinds, NameTheRequestOrAllOfItsKind)
{
  Options options;
  options.ChordalError = 0.1;
  EXPECT_EQ(Rejection("Ranks", options),
    "ChordalError and EdgeLengthArrayName are for one process alone: lengths are graded along the "
    "whole surface");
  options = {};
  options.MakeMaps = true;
  EXPECT_EQ(Rejection("Ranks", options),
    "MakeMaps is for one process alone: the ids of a part are not those of the whole");
}

TEST(RunKinds, OfSeveralAtOnceTellTheFirstThatRejects)
{
  Options options;
  options.Smoothing = 0.2;
  options.DiagnoseInput = true;
  EXPECT_EQ(FindUnsupported(
              { FindRunKind("RanksWithReference"), FindRunKind("Ranks") }, RequestsOf(options)),
    "smoothing with a reference is for one process alone: a process may have a part of it");
}

TEST(RunKinds, AreRejectedByInputsToo)
{
  const std::vector<RunKind> regions = { FindRunKind("Regions") };
  EXPECT_EQ(FindUnsupported(regions, { { "a reference", { Need::Reference }, false } }), "");
  EXPECT_EQ(FindUnsupported(regions, { { "a reference", { Need::Reference }, true } }),
    "a reference needs a run of the whole surface");
}
