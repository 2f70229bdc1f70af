// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"
#include "VtkSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace bonedecimate::testsupport;

namespace
{
constexpr vtkIdType Faces = 1280; // of Sphere(3) and Bumps(3)

/// On a closed surface every collapse removes two triangles.
void ExpectReached(vtkIdType triangles, vtkIdType target)
{
  EXPECT_LE(triangles, target);
  EXPECT_GT(triangles, target - 2);
}

vtkIdType TrianglesAtReduction(double reduction)
{
  FilterRun run(Bumps(3));
  run->SetTargetReduction(reduction);
  return run.Triangles();
}

/// A run towards an error alone, mm.
struct ErrorRun
{
  explicit ErrorRun(double millimeters, int mode = vtkBoneDecimate::BALANCED)
    : Run(Bumps(4))
  {
    this->Run->SetMode(mode);
    this->Run->SetMaximumError(millimeters);
    this->Run->MeasureDistancesOn();
    this->Distances = Values(this->Run.Output(), "Distance");
  }

  FilterRun Run;
  std::vector<double> Distances;
};
}

TEST(Stops, TargetReductionIsTheFractionRemoved)
{
  ExpectReached(TrianglesAtReduction(0.25), 960);
  ExpectReached(TrianglesAtReduction(0.75), 320);
}

TEST(Stops, WithoutAnyTargetNineTenthsAreRemoved)
{
  FilterRun run(Bumps(3));
  ExpectReached(run.Triangles(), 128);
  EXPECT_EQ(run->GetStopReason(), vtkBoneDecimate::TARGET_REACHED);
}

TEST(Stops, AReductionOfNothingLeavesEveryTriangle)
{
  FilterRun run(Bumps(3));
  run->SetTargetReduction(0.0);
  EXPECT_EQ(run.Triangles(), Faces);
  EXPECT_EQ(run->GetStopReason(), vtkBoneDecimate::ALREADY_SATISFIED);
}

TEST(Stops, AReductionOfOneIsOffSoThatTheNumberDecides)
{
  FilterRun run(Bumps(3));
  run->SetTargetReduction(1.0);
  run->SetTargetNumberOfTriangles(400);
  ExpectReached(run.Triangles(), 400);
}

TEST(Stops, WithEveryTargetOffItGoesOnUntilNothingIsLeft)
{
  FilterRun run(Sphere(2));
  run->SetTargetReduction(1.0);
  EXPECT_LT(run.Triangles(), 12);
  EXPECT_GE(run.Triangles(), 4);
  EXPECT_EQ(run->GetStopReason(), vtkBoneDecimate::NOTHING_LEFT);
}

TEST(Stops, TargetNumberOfTrianglesIsWhatIsLeft)
{
  for (const int target : { 1000, 300, 20 })
  {
    FilterRun run(Bumps(3));
    run->SetTargetNumberOfTriangles(target);
    ExpectReached(run.Triangles(), target);
    EXPECT_EQ(run->GetStopReason(), vtkBoneDecimate::TARGET_REACHED);
  }
}

TEST(Stops, ANumberAboveThatOfTheInputChangesNothing)
{
  FilterRun run(Bumps(3));
  run->SetTargetNumberOfTriangles(5000);
  EXPECT_EQ(run.Triangles(), Faces);
  EXPECT_EQ(run->GetStopReason(), vtkBoneDecimate::ALREADY_SATISFIED);
}

TEST(Stops, ANumberAloneSwitchesTheDefaultReductionOff)
{
  FilterRun run(Bumps(3));
  run->SetTargetNumberOfTriangles(60); // the default reduction would stop at 128
  ExpectReached(run.Triangles(), 60);
}

TEST(Stops, OfARequestedReductionAndANumberTheFirstReachedStops)
{
  FilterRun byReduction(Bumps(3));
  byReduction->SetTargetReduction(0.5);
  byReduction->SetTargetNumberOfTriangles(300);
  ExpectReached(byReduction.Triangles(), 640);
  FilterRun byNumber(Bumps(3));
  byNumber->SetTargetNumberOfTriangles(300);
  byNumber->SetTargetReduction(0.9);
  ExpectReached(byNumber.Triangles(), 300);
}

TEST(Stops, ALargerErrorLeavesFewerTriangles)
{
  const vtkIdType fine = ErrorRun(0.02).Run.Triangles();
  const vtkIdType middle = ErrorRun(0.1).Run.Triangles();
  const vtkIdType coarse = ErrorRun(0.5).Run.Triangles();
  EXPECT_LT(middle, fine);
  EXPECT_LT(coarse, middle);
}

TEST(Stops, NoOutputPointLiesBeyondTheErrorAndInThesisAtMostOneDoes)
{
  for (const double millimeters : { 0.02, 0.1, 0.5 })
  {
    ErrorRun error(millimeters);
    ErrorRun thesis(millimeters, vtkBoneDecimate::THESIS);
    const auto isBeyond = [&](double distance) { return distance > millimeters; };
    ASSERT_FALSE(error.Distances.empty());
    EXPECT_EQ(std::count_if(error.Distances.begin(), error.Distances.end(), isBeyond), 0);
    EXPECT_LE(std::count_if(thesis.Distances.begin(), thesis.Distances.end(), isBeyond), 1);
    EXPECT_EQ(error.Run->GetStopReason(), vtkBoneDecimate::ERROR_REACHED);
  }
}

TEST(Stops, ThesisGoesOnUntilTheErrorIsReached)
{
  for (const double millimeters : { 0.02, 0.1, 0.5 })
  {
    ErrorRun error(millimeters, vtkBoneDecimate::THESIS);
    EXPECT_GE(error.Run.Value("running_error"), millimeters);
  }
}

TEST(Stops, AnErrorAloneSwitchesTheDefaultReductionOff)
{
  // Above and below the 512 triangles of the default.
  EXPECT_GT(ErrorRun(0.02).Run.Triangles(), 600);
  EXPECT_LT(ErrorRun(1.0).Run.Triangles(), 500);
}

TEST(Stops, InThesisNumberAndErrorGoOnUntilBothAreReached)
{
  FilterRun numberIsLater(Bumps(4));
  numberIsLater->SetModeToThesis();
  numberIsLater->SetMaximumError(0.02);
  numberIsLater->SetTargetNumberOfTriangles(200);
  ExpectReached(numberIsLater.Triangles(), 200);
  EXPECT_GT(numberIsLater.Value("running_error"), 0.02);

  FilterRun errorIsLater(Bumps(4));
  errorIsLater->SetModeToThesis();
  errorIsLater->SetMaximumError(0.5);
  errorIsLater->SetTargetNumberOfTriangles(5000);
  EXPECT_EQ(errorIsLater.Triangles(), ErrorRun(0.5, vtkBoneDecimate::THESIS).Run.Triangles());
}

TEST(Stops, InThesisReductionAndErrorGoOnUntilBothAreReached)
{
  FilterRun reductionIsLater(Bumps(4));
  reductionIsLater->SetModeToThesis();
  reductionIsLater->SetMaximumError(0.02);
  reductionIsLater->SetTargetReduction(0.95);
  ExpectReached(reductionIsLater.Triangles(), 256);

  FilterRun errorIsLater(Bumps(4));
  errorIsLater->SetModeToThesis();
  errorIsLater->SetMaximumError(0.5);
  errorIsLater->SetTargetReduction(0.1);
  EXPECT_EQ(errorIsLater.Triangles(), ErrorRun(0.5, vtkBoneDecimate::THESIS).Run.Triangles());
}

TEST(Stops, AnErrorThatIsNeverReachedEndsWhenNothingIsLeft)
{
  FilterRun run(Sphere(2));
  run->SetMaximumError(1000.0);
  run->SetAllowLargeError(true);
  run->IntersectionGuardOff(); // the sides of the sphere face each other
  EXPECT_LT(run.Triangles(), 12);
  EXPECT_GE(run.Triangles(), 4);
  EXPECT_EQ(run->GetStopReason(), vtkBoneDecimate::NOTHING_LEFT);
}

TEST(Stops, BeforeAnyRunTheReasonSaysSo)
{
  vtkNew<vtkBoneDecimate> filter;
  EXPECT_EQ(filter->GetStopReason(), vtkBoneDecimate::NOT_RUN);
  EXPECT_FALSE(filter->GetStopReasonAsString().empty());
}
