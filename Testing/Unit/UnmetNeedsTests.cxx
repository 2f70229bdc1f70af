// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionTable.h"
#include "Options/UnmetNeeds.h"
#include "Runs.h"

#include <gtest/gtest.h>

using namespace bonedecimate;

namespace
{
using Names = std::vector<std::string>;

/// The options that have no effect, without their sentences.
Names IneffectiveOf(const Options& options, const Names& given)
{
  Names names;
  for (const std::string& sentence : UnmetNeeds(options, given))
  {
    names.push_back(sentence.substr(0, sentence.find(' ')));
    EXPECT_NE(sentence.find(" has no effect; it needs "), std::string::npos) << sentence;
  }
  return names;
}

const Names Errors = { "AllowLargeError", "IntersectionGuard", "ProveEachEdit", "ProveResult" };
}

TEST(UnmetNeeds, AreNoneOfTheDefaults)
{
  EXPECT_TRUE(ChangedOptions(Options{}).empty());
  EXPECT_TRUE(UnmetNeeds(Options{}, {}).empty());
}

TEST(UnmetNeeds, OfTheErrorNeedOne)
{
  Options options;
  EXPECT_EQ(IneffectiveOf(options, Errors), Errors);
  options.MaximumError = 0.5;
  EXPECT_TRUE(IneffectiveOf(options, Errors).empty());
  options.Mode = Mode::Thesis;
  EXPECT_EQ(
    IneffectiveOf(options, Errors), (Names{ "IntersectionGuard", "ProveEachEdit", "ProveResult" }));
  options = {};
  options.ToleranceArrayName = "Tolerance";
  EXPECT_EQ(IneffectiveOf(options, Errors), Names{ "IntersectionGuard" });
  options = {};
  options.VoxelSize = 0.5;
  EXPECT_EQ(IneffectiveOf(options, { "VoxelSize" }), Names{ "VoxelSize" });
  options.ErrorPreset = ErrorPreset::HalfVoxel;
  EXPECT_TRUE(IneffectiveOf(options, { "VoxelSize" }).empty());
  EXPECT_TRUE(IneffectiveOf(options, Errors).empty());
}

TEST(UnmetNeeds, OfNumbersThatAreOffAreNotTold)
{
  EXPECT_TRUE(IneffectiveOf({}, { "VoxelSize", "ChordalError", "MinimumAngle" }).empty());
  EXPECT_EQ(IneffectiveOf({}, { "NormalTolerance" }), Names{ "NormalTolerance" }); // is never off
}

TEST(UnmetNeeds, AreToldTogetherWithTheOthersOfTheirList)
{
  Options options;
  options.ChordalError = 0.1;
  EXPECT_EQ(UnmetNeeds(options, { "ChordalError" }),
    Names{ "ChordalError has no effect; it needs EdgeLength and Mode Fast, Balanced, Accurate" });
  options = {};
  options.InputErrorBoundArrayName = "Bound";
  EXPECT_EQ(UnmetNeeds(options, { "InputErrorBoundArrayName" }),
    Names{ "InputErrorBoundArrayName has no effect; it needs MeasureInputDistances and ProveResult "
           "with MaximumError, ErrorPreset or ToleranceArrayName, and another Mode than Thesis" });
}

TEST(UnmetNeeds, ShapesNeedEditsOfAModeThatKeepsThem)
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

TEST(UnmetNeeds, LocalLengthsNeedAnEdgeLength)
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

TEST(UnmetNeeds, OfRoundsNeedAModeThatMakesThem)
{
  const Names effort = { "RefinementEffort" };
  Options options;
  EXPECT_EQ(IneffectiveOf(options, effort), effort);
  options.ToleranceArrayName = "Tolerance";
  EXPECT_TRUE(IneffectiveOf(options, effort).empty());
  options.Mode = Mode::Fast;
  EXPECT_EQ(IneffectiveOf(options, effort), effort);
}

TEST(UnmetNeeds, OfTheThesisNeedItsMode)
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

TEST(UnmetNeeds, OfArraysNeedWhatFillsThem)
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

TEST(UnmetNeeds, FindsWhatIsNotTheDefault)
{
  Options options;
  options.VoxelSize = 0.5;
  options.IntersectionGuard = false;
  EXPECT_EQ(ChangedOptions(options), (Names{ "IntersectionGuard", "VoxelSize" }));
  EXPECT_EQ(UnmetNeeds(options, ChangedOptions(options)),
    (Names{
      "IntersectionGuard has no effect; it needs MaximumError or ErrorPreset, and another Mode "
      "than Thesis",
      "VoxelSize has no effect; it needs ErrorPreset" }));
}

TEST(UnmetNeeds, AreWarnedOfInEveryRun)
{
  const Surface ball = testsupport::Icosphere(2, 10.0);
  Options options;
  options.IntersectionGuard = false;
  options.DistanceArrayName = "far";
  const Report idle = Decimate(ball, options).Report;
  EXPECT_EQ(InputWarnings(idle), UnmetNeeds(options, { "IntersectionGuard" }));
  options.MaximumError = 0.5;
  EXPECT_TRUE(InputWarnings(Decimate(ball, options).Report).empty());
  options = {};
  options.ProveResult = false;
  const std::vector<double> tolerances(ball.Points.size(), 0.5);
  EXPECT_EQ(InputWarnings(Decimate(ball, options).Report).size(), 1);
  const Report limited = Decimate(ball, options, {}, { false, false, &tolerances }).Report;
  EXPECT_TRUE(InputWarnings(limited).empty());
}
