// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/IneffectiveOptions.h"

#include "Options/OptionTable.h"
#include "Runs.h"

#include <gtest/gtest.h>

using namespace bonedecimate;

namespace
{
using Names = std::vector<std::string>;

/// The options that are idle, without their sentences.
Names IneffectiveOf(const Options& options, const Names& given)
{
  Names names;
  for (const std::string& sentence : IneffectiveOptions(options, given))
  {
    names.push_back(sentence.substr(0, sentence.find(' ')));
    EXPECT_NE(sentence.find(" has no effect; it needs "), std::string::npos) << sentence;
  }
  return names;
}

const Names Errors = { "AllowLargeError", "IntersectionGuard", "ProveResult" };
}

TEST(IneffectiveOptions, AreNoneOfTheDefaults)
{
  EXPECT_TRUE(ChangedOptions(Options{}).empty());
  EXPECT_TRUE(IneffectiveOptions(Options{}, {}).empty());
}

TEST(IneffectiveOptions, OfTheErrorNeedOne)
{
  Options options;
  EXPECT_EQ(IneffectiveOf(options, Errors), Errors);
  options.MaximumError = 0.5;
  EXPECT_TRUE(IneffectiveOf(options, Errors).empty());
  options.Mode = Mode::Thesis;
  EXPECT_EQ(IneffectiveOf(options, Errors), (Names{ "IntersectionGuard", "ProveResult" }));
  options = {};
  options.ToleranceArrayName = "Tolerance";
  EXPECT_EQ(IneffectiveOf(options, Errors), Names{ "IntersectionGuard" });
  options = {};
  EXPECT_EQ(IneffectiveOf(options, { "VoxelSize" }), Names{ "VoxelSize" });
  options.ErrorPreset = ErrorPreset::HalfVoxel;
  EXPECT_TRUE(IneffectiveOf(options, { "VoxelSize" }).empty());
  EXPECT_TRUE(IneffectiveOf(options, Errors).empty());
}

TEST(IneffectiveOptions, ShapesNeedEditsOfAModeThatKeepsThem)
{
  const Names shape = { "MinimumAngle", "EdgeLength" };
  Options options;
  options.MinimumAngle = 20.0;
  options.EdgeLength = 2.0;
  EXPECT_TRUE(IneffectiveOf(options, shape).empty());
  options.TargetReductionIsExplicit = true;
  EXPECT_TRUE(IneffectiveOf(options, shape).empty());
  options.TargetReduction = 0.0;
  EXPECT_EQ(IneffectiveOf(options, shape), shape);
  options = {};
  options.MinimumAngle = 20.0;
  options.EdgeLength = 2.0;
  options.Mode = Mode::Thesis;
  EXPECT_EQ(IneffectiveOf(options, shape), shape);
}

TEST(IneffectiveOptions, LocalLengthsNeedAnEdgeLength)
{
  const Names local = { "ChordalError", "EdgeLengthArrayName" };
  Options options;
  options.ChordalError = 0.1;
  options.EdgeLengthArrayName = "Size";
  EXPECT_EQ(IneffectiveOf(options, local), local);
  options.EdgeLength = 2.0;
  EXPECT_TRUE(IneffectiveOf(options, local).empty());
  options.Mode = Mode::Thesis;
  EXPECT_EQ(IneffectiveOf(options, local), local);
}

TEST(IneffectiveOptions, OfRoundsNeedAModeThatMakesThem)
{
  const Names effort = { "RefinementEffort" };
  Options options;
  EXPECT_EQ(IneffectiveOf(options, effort), effort);
  options.ToleranceArrayName = "Tolerance";
  EXPECT_TRUE(IneffectiveOf(options, effort).empty());
  options.Mode = Mode::Fast;
  EXPECT_EQ(IneffectiveOf(options, effort), effort);
}

TEST(IneffectiveOptions, OfTheThesisNeedItsMode)
{
  const Names both = { "NormalTolerance", "AutomaticNormalTolerance" };
  Options options;
  EXPECT_EQ(IneffectiveOf(options, both), both);
  options.Mode = Mode::Thesis;
  EXPECT_TRUE(IneffectiveOf(options, both).empty());
  options.AutomaticNormalTolerance = true;
  EXPECT_EQ(IneffectiveOf(options, both), Names{ "NormalTolerance" });
  options.MaximumError = 0.5; // the default reduction is ignored, so there is no number
  EXPECT_EQ(IneffectiveOf(options, both), Names{ "AutomaticNormalTolerance" });
  options.TargetNumberOfTriangles = 100;
  EXPECT_EQ(IneffectiveOf(options, both), Names{ "NormalTolerance" });
}

TEST(IneffectiveOptions, OfArraysNeedWhatFillsThem)
{
  const Names all = { "DistanceArrayName", "RunningErrorArrayName", "InputDistanceArrayName",
    "ErrorBoundArrayName", "InputErrorBoundArrayName" };
  Options options;
  options.MeasureDistances = false;
  EXPECT_EQ(IneffectiveOf(options, all), all);
  options.MeasureDistances = options.MeasureInputDistances = true;
  options.MaximumError = 0.5;
  EXPECT_TRUE(IneffectiveOf(options, all).empty());
  options.ProveResult = false;
  EXPECT_EQ(
    IneffectiveOf(options, all), (Names{ "ErrorBoundArrayName", "InputErrorBoundArrayName" }));
}

TEST(IneffectiveOptions, FindsWhatIsNotTheDefault)
{
  Options options;
  options.VoxelSize = 0.5;
  options.IntersectionGuard = false;
  EXPECT_EQ(ChangedOptions(options), (Names{ "IntersectionGuard", "VoxelSize" }));
  EXPECT_EQ(IneffectiveOptions(options, ChangedOptions(options)),
    (Names{
      "IntersectionGuard has no effect; it needs MaximumError or ErrorPreset, and another Mode "
      "than Thesis",
      "VoxelSize has no effect; it needs ErrorPreset" }));
}

TEST(IneffectiveOptions, AreWarnedOfInEveryRun)
{
  const Surface ball = testsupport::Icosphere(2, 10.0);
  Options options;
  options.IntersectionGuard = false;
  options.DistanceArrayName = "far";
  const Report idle = Decimate(ball, options).Report;
  EXPECT_EQ(InputWarnings(idle), IneffectiveOptions(options, { "IntersectionGuard" }));
  options.MaximumError = 0.5;
  EXPECT_TRUE(InputWarnings(Decimate(ball, options).Report).empty());
  options = {};
  options.ProveResult = false;
  const std::vector<double> tolerances(ball.Points.size(), 0.5);
  EXPECT_EQ(InputWarnings(Decimate(ball, options).Report).size(), 1);
  const Report limited = Decimate(ball, options, {}, { false, false, &tolerances }).Report;
  EXPECT_TRUE(InputWarnings(limited).empty());
}
