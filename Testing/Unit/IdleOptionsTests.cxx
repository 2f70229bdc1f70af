// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IdleOptions.h"

#include "OptionTable.h"
#include "Runs.h"

#include <gtest/gtest.h>

using namespace bonedecimate;

namespace
{
using Names = std::vector<std::string>;

/// The options that are idle, without their sentences.
Names IdleOf(const Options& options, const Names& given)
{
  Names names;
  for (const std::string& sentence : IdleOptions(options, given))
  {
    names.push_back(sentence.substr(0, sentence.find(' ')));
    EXPECT_NE(sentence.find(" has no effect; it needs "), std::string::npos) << sentence;
  }
  return names;
}

const Names Errors = { "AllowLargeError", "KeepClearance", "ProveResult" };
}

TEST(IdleOptions, AreNoneOfTheDefaults)
{
  EXPECT_TRUE(ChangedOptions(Options{}).empty());
  EXPECT_TRUE(IdleOptions(Options{}, {}).empty());
}

TEST(IdleOptions, OfTheErrorNeedOne)
{
  Options options;
  EXPECT_EQ(IdleOf(options, Errors), Errors);
  options.MaximumError = 0.5;
  EXPECT_TRUE(IdleOf(options, Errors).empty());
  options.Mode = Mode::Thesis;
  EXPECT_EQ(IdleOf(options, Errors), (Names{ "KeepClearance", "ProveResult" }));
  options = {};
  options.ToleranceArrayName = "Tolerance";
  EXPECT_EQ(IdleOf(options, Errors), Names{ "KeepClearance" });
  options = {};
  EXPECT_EQ(IdleOf(options, { "VoxelSize" }), Names{ "VoxelSize" });
  options.ErrorPreset = ErrorPreset::HalfVoxel;
  EXPECT_TRUE(IdleOf(options, { "VoxelSize" }).empty());
  EXPECT_TRUE(IdleOf(options, Errors).empty());
}

TEST(IdleOptions, OfTheThesisNeedItsMode)
{
  const Names both = { "NormalTolerance", "AutomaticNormalTolerance" };
  Options options;
  EXPECT_EQ(IdleOf(options, both), both);
  options.Mode = Mode::Thesis;
  EXPECT_TRUE(IdleOf(options, both).empty());
  options.AutomaticNormalTolerance = true;
  EXPECT_EQ(IdleOf(options, both), Names{ "NormalTolerance" });
  options.MaximumError = 0.5; // the default reduction is ignored, so there is no number
  EXPECT_EQ(IdleOf(options, both), Names{ "AutomaticNormalTolerance" });
  options.TargetNumberOfTriangles = 100;
  EXPECT_EQ(IdleOf(options, both), Names{ "NormalTolerance" });
}

TEST(IdleOptions, OfArraysNeedWhatFillsThem)
{
  const Names all = { "DistanceArrayName", "RunningErrorArrayName", "InputDistanceArrayName",
    "ErrorBoundArrayName", "InputErrorBoundArrayName" };
  Options options;
  options.MeasureDistances = false;
  EXPECT_EQ(IdleOf(options, all), all);
  options.MeasureDistances = options.MeasureInputDistances = true;
  options.MaximumError = 0.5;
  EXPECT_TRUE(IdleOf(options, all).empty());
  options.ProveResult = false;
  EXPECT_EQ(IdleOf(options, all), (Names{ "ErrorBoundArrayName", "InputErrorBoundArrayName" }));
}

TEST(IdleOptions, FindsWhatIsNotTheDefault)
{
  Options options;
  options.VoxelSize = 0.5;
  options.KeepClearance = false;
  EXPECT_EQ(ChangedOptions(options), (Names{ "KeepClearance", "VoxelSize" }));
  EXPECT_EQ(IdleOptions(options, ChangedOptions(options)),
    (Names{ "KeepClearance has no effect; it needs MaximumError or ErrorPreset, and another Mode "
            "than Thesis",
      "VoxelSize has no effect; it needs ErrorPreset" }));
}

TEST(IdleOptions, AreWarnedOfInEveryRun)
{
  const Surface ball = testsupport::Icosphere(2, 10.0);
  Options options;
  options.KeepClearance = false;
  options.DistanceArrayName = "far";
  const Report idle = Decimate(ball, options).Report;
  EXPECT_EQ(InputWarnings(idle), IdleOptions(options, { "KeepClearance" }));
  options.MaximumError = 0.5;
  EXPECT_TRUE(InputWarnings(Decimate(ball, options).Report).empty());
  options = {};
  options.ProveResult = false;
  const std::vector<double> tolerances(ball.Points.size(), 0.5);
  EXPECT_EQ(InputWarnings(Decimate(ball, options).Report).size(), 1);
  const Report limited = Decimate(ball, options, {}, { false, false, &tolerances }).Report;
  EXPECT_TRUE(InputWarnings(limited).empty());
}
