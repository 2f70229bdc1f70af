// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The table of modes: rows that its parts can carry out, and names that options, report and
// messages take from it.
#include "Options/Modes.h"

#include "Decimate/Cost/QuadricDeviation.h"
#include "Decimate/Kernels/EdgeEvaluator.h"
#include "Decimate/Placement/AlternatePositions.h"
#include "Decimate/Placement/VolumePreserving.h"
#include "Decimate/Stages/CollapseStage.h"
#include "Options/OptionTable.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

TEST(Modes, StandInTheTableInTheOrderOfTheirNumbers)
{
  std::set<std::string> names;
  for (std::size_t i = 0; i < ModeTable().size(); ++i)
  {
    const ModeInfo& mode = ModeTable()[i];
    EXPECT_EQ(static_cast<std::size_t>(mode.Mode), i);
    EXPECT_EQ(&FindMode(mode.Mode), &mode);
    EXPECT_TRUE(names.insert(mode.Name).second) << mode.Name;
  }
  EXPECT_EQ(FindOption("Mode")->Choices, ModeNames());
  EXPECT_EQ(FindMode(static_cast<Mode>(-1)).Mode, Mode::Balanced);
  EXPECT_EQ(FindMode(static_cast<Mode>(99)).Mode, Mode::Balanced);
}

TEST(Modes, HaveVectorKernelsForQuadricDeviation)
{
  EXPECT_TRUE(EdgeEvaluator({ QuadricDeviation, VolumePreservingPosition }).HasKernel());
  for (const ModeInfo& mode : ModeTable())
  {
    const auto* sweep = std::get_if<SweepPolicies>(&mode.Schedule);
    EXPECT_TRUE(
      sweep == nullptr || sweep->Cost != QuadricDeviation || EdgeEvaluator(*sweep).HasKernel())
      << mode.Name;
  }
}

TEST(Modes, ThatStopAtAnErrorRecordDistances)
{
  for (const ModeInfo& mode : ModeTable())
  {
    EXPECT_TRUE(mode.ProvesError() || mode.RecordsDistances) << mode.Name;
  }
}

TEST(Modes, BeginWithACollapseAndEndAtTheEnd)
{
  for (const ModeInfo& mode : ModeTable())
  {
    ASSERT_FALSE(mode.Stages.empty()) << mode.Name;
    EXPECT_EQ(mode.Stages.front().Run, &CollapseStage) << mode.Name;
    EXPECT_EQ(mode.Stages.back().End, 1.0) << mode.Name;
    double begin = 0.0;
    for (const Stage& stage : mode.Stages)
    {
      EXPECT_GT(stage.End, begin) << mode.Name << " " << stage.Name;
      begin = stage.End;
    }
    EXPECT_EQ(mode.Stages.size() > 1, mode.KeepsInitialMesh) << mode.Name;
    EXPECT_GE(mode.Sweep.PositionsTried, 1) << mode.Name;
    EXPECT_LE(mode.Sweep.PositionsTried, MaximumPositions) << mode.Name;
  }
}

TEST(Modes, OfAPredicateAreListedByName)
{
  EXPECT_EQ(ModeNamesWhere([](const ModeInfo& mode)
              { return mode.Mode == Mode::Fast || mode.Mode == Mode::Accurate; }),
    "Fast, Accurate");
  EXPECT_EQ(
    ModeNamesWhere([](const ModeInfo& mode) { return mode.HasNormalTolerance(); }), "Thesis");
  EXPECT_EQ(ModeNamesWhere([](const ModeInfo&) { return false; }), "");
}

TEST(Stages, DoNothingWhereTheTargetIsReached)
{
  const CleanSurface cleaned = Clean(Icosphere(2, 10.0), true);
  for (const ModeInfo& mode : ModeTable())
  {
    Editor editor(cleaned,
      EditorSettings{ mode.RecordsDistances, mode.NeedsFaceAreas(), mode.NeedsQuadrics(),
        mode.KeepsInitialMesh });
    const StopTargets stops = { editor.Mesh().NumberOfFaces(), 0.0 };
    EXPECT_EQ(
      RunStages({ editor, mode, stops }, [](double) { return true; }), StopReason::AlreadySatisfied)
      << mode.Name;
    EXPECT_EQ(editor.Totals().Collapses, 0) << mode.Name;
  }
}

TEST(Stages, EndWithTheFirstThatIsAborted)
{
  const CleanSurface cleaned = Clean(BumpySphere(3, 5.0, 0.1, 7), true);
  for (const ModeInfo& mode : ModeTable())
  {
    Editor editor(cleaned,
      EditorSettings{ mode.RecordsDistances, mode.NeedsFaceAreas(), mode.NeedsQuadrics(),
        mode.KeepsInitialMesh });
    const StopTargets stops = { editor.Mesh().NumberOfFaces() / 4, 0.0 };
    double last = 0.0;
    const auto abortAtOnce = [&](double done)
    {
      last = std::max(last, done);
      return false;
    };
    EXPECT_EQ(RunStages({ editor, mode, stops, 0.95 }, abortAtOnce), StopReason::Aborted)
      << mode.Name;
    EXPECT_LE(last, mode.Stages.front().End) << mode.Name;
  }
}
