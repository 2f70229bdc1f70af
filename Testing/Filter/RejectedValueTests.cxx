// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// A value outside its range is an error event when it is set; the value before stays, and updates
// fail with the same sentence until that property gets a valid value. PropertyTests.cxx does the
// same for vtkBoneDecimate.
#include "FilterRun.h"
#include "LabelImages.h"
#include "Options/Modes.h"
#include "RejectionWalk.h"
#include "VtkSurfaces.h"

#include "vtkBoneDecimate.h"
#include "vtkBoneDecimateLevels.h"
#include "vtkBoneDiagnostics.h"
#include "vtkBoneErrorSearch.h"
#include "vtkBoneSurfaceDistance.h"
#include "vtkBoneSurfaces.h"
#include "vtkBoneTolerance.h"
#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSphere.h"
#include "vtkTable.h"

#include <cmath>

using namespace bonedecimate::testsupport;

namespace
{
/// A numeric property of a filter by its name.
#define CHECKED(filter, name, good, bad)                                                           \
  CheckedProperty                                                                                  \
  {                                                                                                \
#name, good, bad,                                                                              \
      [filter](double value)                                                                       \
    { filter->Set##name(static_cast<decltype(filter->Get##name())>(value)); },                     \
      [filter] { return static_cast<double>(filter->Get##name()); },                               \
        [filter](const std::string& rejected) { return filter->GetRejectedValue(rejected); }       \
  }

constexpr double MostMillimeters = 1e30;
const double NotANumber = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkPolyData> WithArray(const char* name, double valueOfPoint5)
{
  vtkSmartPointer<vtkPolyData> surface = Sphere(1);
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  array->Fill(1.0);
  array->SetValue(5, valueOfPoint5);
  surface->GetPointData()->AddArray(array);
  return surface;
}
}

TEST(ErrorCode, SaysWhyAnUpdateFailedAndIsGoneAfterTheNext)
{
  FilterRun run(Bumps(3));
  run.Output();
  EXPECT_EQ(run->GetErrorCode(), 0U);
  run->SetMaximumError(-1.0);
  run.Output();
  EXPECT_EQ(run->GetErrorCode(), static_cast<unsigned long>(vtkBoneDecimate::REJECTED_VALUE));
  run->SetMaximumError(0.2);
  run->SetToleranceArrayName("Nothing");
  run.Output();
  EXPECT_EQ(run->GetErrorCode(), static_cast<unsigned long>(vtkBoneDecimate::REJECTED_RUN));
  run->SetToleranceArrayName("");
  run.Output();
  EXPECT_EQ(run->GetErrorCode(), 0U);
}

TEST(Report, OfARunDoesNotOutliveItsSurface)
{
  FilterRun run(Bumps(3));
  run->SetMaximumError(0.2);
  run.Output();
  ASSERT_EQ(run->GetProofStatus(), vtkBoneDecimate::PROVED);
  const auto expectNothing = [&run]
  {
    EXPECT_EQ(run.Output()->GetNumberOfPoints(), 0);
    EXPECT_EQ(run->GetProofStatus(), vtkBoneDecimate::NO_PROOF);
    EXPECT_TRUE(std::isnan(run->GetProvedError()));
    EXPECT_EQ(run->GetNumberOfOutputTriangles(), 0);
    EXPECT_EQ(run->GetStopReason(), vtkBoneDecimate::NOT_RUN);
    EXPECT_TRUE(std::isnan(run->GetReportValue("proof.upper")));
  };
  run->SetLabelArrayName("Nothing");
  expectNothing();
  run->SetLabelArrayName("");
  run.Output();
  ASSERT_EQ(run->GetProofStatus(), vtkBoneDecimate::PROVED);
  run->SetMaximumError(-1.0);
  expectNothing();
}

TEST(RejectedValues, OfTheSurfaceDistance)
{
  const vtkNew<vtkBoneSurfaceDistance> held;
  vtkBoneSurfaceDistance* filter = held;
  filter->SetInputData(0, Sphere(1));
  filter->SetInputData(1, Sphere(0));
  filter->MeasureMeansOff();
  for (const CheckedProperty& property :
    { CHECKED(filter, Tolerance, 5.0, NumbersOutside(0.0, MostMillimeters)),
      CHECKED(filter, RelativeGap, 0.01, NumbersOutside(1e-12, 1.0)),
      CHECKED(filter, MeanPrecision, 0.5, NumbersOutside(1e-4, 1.0)),
      CHECKED(filter, NumberOfThreads, 1, IntegersOutside(0, 1024)) })
  {
    ExpectRejections(filter, property);
  }
  EXPECT_EQ(filter->GetStatus(), vtkBoneSurfaceDistance::PROVED);
}

TEST(RejectedValues, RemovingTheToleranceIsNoValueOutsideItsRange)
{
  vtkNew<vtkBoneSurfaceDistance> filter;
  ErrorTexts errors(filter);
  filter->SetInputData(0, Sphere(1));
  filter->SetInputData(1, Sphere(0));
  filter->SetTolerance(1.0);
  filter->SetTolerance(-1.0);
  EXPECT_EQ(errors.Texts.size(), 1U);
  filter->RemoveTolerance();
  filter->Update();
  EXPECT_EQ(errors.Texts.size(), 1U);
  EXPECT_EQ(filter->GetStatus(), vtkBoneSurfaceDistance::NOT_REQUESTED);
  filter->SetToleranceOrNone(0.5);
  EXPECT_EQ(filter->GetTolerance(), 0.5);
  filter->SetToleranceOrNone(-1.0);
  EXPECT_EQ(filter->GetTolerance(), -1.0);
  EXPECT_EQ(errors.Texts.size(), 1U);
  filter->SetToleranceOrNone(-0.5);
  EXPECT_EQ(errors.Texts.size(), 2U);
}

TEST(RejectedValues, TolerancesOfPointsThatAreNoNumbersAreErrors)
{
  for (const double bad : { NotANumber, std::numeric_limits<double>::infinity(), 1e31 })
  {
    vtkNew<vtkBoneSurfaceDistance> filter;
    ErrorTexts errors(filter);
    filter->SetInputData(0, WithArray("Tolerance", bad));
    filter->SetInputData(1, Sphere(0));
    filter->SetToleranceArrayName("Tolerance");
    filter->Update();
    EXPECT_EQ(errors.Count("NaN or beyond 1e30 mm, the first is point 5"), 1) << bad;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << bad;
  }
}

TEST(RejectedValues, OfTheTolerance)
{
  const vtkNew<vtkBoneTolerance> held;
  vtkBoneTolerance* filter = held;
  filter->SetInputData(Sphere(1));
  for (const CheckedProperty& property :
    { CHECKED(filter, Choice, vtkBoneTolerance::BOUNDARIES, IntegersOutside(0, 7)),
      CHECKED(filter, FoldAngle, 45.0, NumbersOutside(0.0, 180.0)),
      CHECKED(filter, InsideTolerance, 0.25, NumbersOutside(-MostMillimeters, MostMillimeters)),
      CHECKED(filter, OutsideTolerance, 0.5, NumbersOutside(-MostMillimeters, MostMillimeters)),
      CHECKED(filter, Feather, 2.0, NumbersOutside(0.0, MostMillimeters)) })
  {
    ExpectRejections(filter, property);
  }
}

TEST(RejectedValues, FunctionsAndArraysThatAreNoNumbersAreErrorsOfTheTolerance)
{
  vtkNew<vtkBoneTolerance> filter;
  ErrorTexts errors(filter);
  filter->SetInputData(Sphere(1));
  filter->SetChoiceToImplicitFunction();
  vtkNew<vtkSphere> ball;
  ball->SetRadius(NotANumber);
  filter->SetImplicitFunction(ball);
  filter->Update();
  EXPECT_EQ(errors.Count("implicit function is NaN"), 1);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetChoiceToEverything();
  filter->SetInputData(WithArray("Tolerance", NotANumber));
  filter->Update();
  EXPECT_EQ(errors.Count("its value of point 5 is NaN"), 1);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(RejectedValues, OfTheLevels)
{
  constexpr int most = std::numeric_limits<int>::max();
  const int lastMode = static_cast<int>(bonedecimate::ModeTable().size()) - 1;
  const vtkNew<vtkBoneDecimateLevels> held;
  vtkBoneDecimateLevels* filter = held;
  filter->SetInputData(Sphere(1));
  for (const CheckedProperty& property : { CHECKED(filter, Mode, 1, IntegersOutside(0, lastMode)),
         CHECKED(filter, TargetNumberOfTriangles, 20, IntegersOutside(0, most)),
         CHECKED(filter, MaximumError, 2.0, NumbersOutside(0.0, MostMillimeters)),
         CHECKED(filter, NumberOfThreads, 1, IntegersOutside(0, 1024)),
         CHECKED(filter, NumberOfTriangles, 40, IntegersOutside(0, most)),
         CHECKED(filter, LevelError, 1.0, NumbersOutside(0.0, MostMillimeters)) })
  {
    ExpectRejections(filter, property);
  }
}

TEST(RejectedValues, OfTheErrorSearch)
{
  const vtkNew<vtkBoneErrorSearch> held;
  vtkBoneErrorSearch* filter = held;
  filter->SetInputData(Sphere(1));
  filter->AddError(1.0); // one run for each update
  for (const CheckedProperty& property :
    { CHECKED(filter, Mode, 1, (std::vector<double>{ 0.0, 4.0, -1.0, -2147483648.0 })),
      CHECKED(
        filter, TargetNumberOfTriangles, 40, IntegersOutside(0, std::numeric_limits<int>::max())),
      CHECKED(filter, RelativePrecision, 0.25, NumbersOutside(0.001, 0.5)),
      CHECKED(filter, NumberOfThreads, 1, IntegersOutside(0, 1024)) })
  {
    ExpectRejections(filter, property);
  }
}

TEST(RejectedValues, CurvesNeverLackAnErrorSilently)
{
  std::vector<double> bad = NumbersOutside(0.0, MostMillimeters);
  bad.push_back(0.0);
  for (const double error : bad)
  {
    vtkNew<vtkBoneErrorSearch> filter;
    ErrorTexts errors(filter);
    filter->SetInputData(Sphere(1));
    filter->AddError(1.0);
    filter->AddError(error);
    EXPECT_EQ(filter->GetNumberOfErrors(), 1) << error;
    filter->AddError(2.0);
    filter->Update();
    EXPECT_EQ(errors.Count("Error takes a number above 0"), 2) << error;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << error;
    filter->RemoveAllErrors();
    filter->AddError(2.0);
    errors.Texts.clear();
    filter->Update();
    EXPECT_TRUE(errors.Texts.empty());
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(RejectedValues, OfTheSurfaces)
{
  const vtkNew<vtkBoneSurfaces> held;
  vtkBoneSurfaces* filter = held;
  filter->SetInputData(ImageOf(EllipsoidLabels({ 6, 7, 8 })));
  for (const CheckedProperty& property :
    { CHECKED(filter, OutputPointsPrecision, 1, IntegersOutside(0, 2)),
      CHECKED(filter, NumberOfThreads, 1, IntegersOutside(0, 1024)) })
  {
    ExpectRejections(filter, property);
  }
}

TEST(RejectedValues, OfTheCheck)
{
  const vtkNew<vtkBoneDiagnostics> held;
  vtkBoneDiagnostics* filter = held;
  filter->SetInputData(Sphere(1));
  ExpectRejections(filter, CHECKED(filter, NumberOfThreads, 1, IntegersOutside(0, 1024)));
}

namespace
{
/// A filter with a largest error of 100 mm, for a ball with a bounding box of 20 mm.
template <typename Filter>
void ExpectRejectionUntilAllowed(Filter* filter)
{
  ErrorTexts errors(filter);
  const vtkNew<vtkCallbackCommand> silent; // a warning about the error that is used instead
  filter->AddObserver(vtkCommand::WarningEvent, silent);
  filter->SetInputData(Sphere(1));
  filter->Update();
  EXPECT_EQ(errors.Count("the largest error of 100 mm is more than a quarter"), 1);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  errors.Texts.clear();
  filter->AllowLargeErrorOn();
  filter->Update();
  EXPECT_TRUE(errors.Texts.empty());
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
}
}

TEST(LargeErrors, AreRejectedByEveryFilterUntilTheyAreAllowed)
{
  const vtkNew<vtkBoneDecimate> decimate;
  decimate->SetMaximumError(100.0);
  ExpectRejectionUntilAllowed(decimate.Get());
  const vtkNew<vtkBoneDecimateLevels> levels;
  levels->SetMaximumError(100.0);
  ExpectRejectionUntilAllowed(levels.Get());
  const vtkNew<vtkBoneErrorSearch> curve;
  curve->AddError(0.5);
  curve->AddError(100.0);
  curve->AddError(1.0);
  ExpectRejectionUntilAllowed(curve.Get());
  EXPECT_EQ(curve->GetTrials()->GetNumberOfRows(), 3);
}
