// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkBoneTolerance turns choices into tolerances.
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkBoneTolerance.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// The filter with a surface, its array as numbers; counts its errors.
class ToleranceRun
{
public:
  explicit ToleranceRun(vtkPolyData* surface)
  {
    this->Filter->SetInputData(surface);
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this, &ToleranceRun::OnError);
    this->Filter->GetExecutive()->AddObserver(
      vtkCommand::ErrorEvent, this, &ToleranceRun::OnNothing);
  }
  vtkBoneTolerance* operator->() { return this->Filter; }
  vtkPolyData* Output()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
  std::vector<double> Tolerances() { return Values(this->Output(), "Tolerance"); }

  int Errors = 0;

private:
  void OnError(vtkObject*, unsigned long, void*) { ++this->Errors; }
  void OnNothing(vtkObject*, unsigned long, void*) {}

  vtkNew<vtkBoneTolerance> Filter;
};

/// A grid of 8 x 8 unit squares.
vtkSmartPointer<vtkPolyData> Plate()
{
  return PolyData(Grid(8));
}

vtkSmartPointer<vtkSphere> Ball(double x, double y, double radius)
{
  auto ball = vtkSmartPointer<vtkSphere>::New();
  ball->SetCenter(x, y, 0.0);
  ball->SetRadius(radius);
  return ball;
}
}

TEST(BoneTolerance, ConstrainsEverythingByDefault)
{
  ToleranceRun run(Plate());
  EXPECT_EQ(run.Tolerances(), std::vector<double>(81, 0.0));
  EXPECT_STREQ(run.Output()->GetPointData()->GetArray("Tolerance")->GetComponentName(0), "mm");
}

TEST(BoneTolerance, ChoosesPointsWhereAFunctionIsNotPositive)
{
  ToleranceRun run(Plate());
  run->SetChoiceToImplicitFunction();
  run->SetImplicitFunction(Ball(4.0, 4.0, 2.0));
  run->SetInsideTolerance(0.1);
  run->SetOutsideTolerance(0.4);
  for (const bool inverted : { false, true })
  {
    run->SetInverted(inverted);
    const std::vector<double> found = run.Tolerances();
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const double* p = run.Output()->GetPoint(static_cast<vtkIdType>(i));
      const bool isInside = std::hypot(p[0] - 4.0, p[1] - 4.0) <= 2.0;
      EXPECT_EQ(found[i], isInside != inverted ? 0.1 : 0.4) << p[0] << " " << p[1];
    }
  }
}

TEST(BoneTolerance, GoesLinearlyThroughTheFeather)
{
  ToleranceRun run(Plate());
  run->SetChoiceToImplicitFunction();
  vtkNew<vtkPlane> left;
  left->SetOrigin(2.0, 0.0, 0.0);
  left->SetNormal(1.0, 0.0, 0.0);
  run->SetImplicitFunction(left);
  run->SetInsideTolerance(0.1);
  run->SetOutsideTolerance(0.5);
  run->SetFeather(4.0);
  const std::vector<double> found = run.Tolerances();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const double x = run.Output()->GetPoint(static_cast<vtkIdType>(i))[0];
    EXPECT_NEAR(found[i], x <= 2.0 ? 0.1 : std::min(0.5, 0.1 + 0.1 * (x - 2.0)), 1e-12) << x;
  }
}

TEST(BoneTolerance, ChoosesByValueOrByLabel)
{
  vtkSmartPointer<vtkPolyData> plate = Plate();
  vtkNew<vtkIntArray> labels;
  labels->SetName("Choice");
  for (vtkIdType i = 0; i < plate->GetNumberOfPoints(); ++i)
  {
    labels->InsertNextValue(static_cast<int>(i % 5));
  }
  plate->GetPointData()->AddArray(labels);
  ToleranceRun run(plate);
  run->SetChoiceToPointArray();
  std::vector<double> found = run.Tolerances();
  run->AddLabel(2);
  run->AddLabel(3);
  const std::vector<double> labeled = run.Tolerances();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i], i % 5 != 0 ? 0.0 : -1.0);
    EXPECT_EQ(labeled[i], i % 5 == 2 || i % 5 == 3 ? 0.0 : -1.0);
  }
  EXPECT_EQ(run->GetNumberOfLabels(), 2);
  EXPECT_EQ(run->GetLabel(1), 3);
  run->RemoveAllLabels();
  EXPECT_EQ(run.Tolerances(), found);
}

TEST(BoneTolerance, OfCellsHoldsAllTheirPointsOnEitherSide)
{
  vtkSmartPointer<vtkPolyData> plate = Plate();
  vtkNew<vtkFloatArray> mask;
  mask->SetName("brush");
  for (vtkIdType cell = 0; cell < plate->GetNumberOfCells(); ++cell)
  {
    mask->InsertNextValue(cell < 16 ? 1.0F : 0.0F); // the first row of squares
  }
  plate->GetCellData()->AddArray(mask);
  ToleranceRun run(plate);
  run->SetChoiceToCellArray();
  run->SetChoiceArrayName("brush");
  for (const bool inverted : { false, true })
  {
    run->SetInverted(inverted);
    const std::vector<double> found = run.Tolerances();
    std::vector<double> expected(found.size(), -1.0);
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < plate->GetNumberOfCells(); ++cell)
    {
      plate->GetCellPoints(cell, ids);
      for (vtkIdType k = 0; k < 3 && (cell < 16) != inverted; ++k)
      {
        expected[static_cast<std::size_t>(ids->GetId(k))] = 0.0;
      }
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(BoneTolerance, TakesSelectionsOfPointsAndOfCells)
{
  vtkSmartPointer<vtkPolyData> plate = Plate();
  for (const int field : { vtkSelectionNode::POINT, vtkSelectionNode::CELL })
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->InsertNextValue(5);
    vtkNew<vtkSelectionNode> node;
    node->SetFieldType(field);
    node->SetContentType(vtkSelectionNode::INDICES);
    node->SetSelectionList(ids);
    vtkNew<vtkSelection> selection;
    selection->AddNode(node);
    ToleranceRun run(plate);
    run->SetChoiceToSelection();
    run->SetInputData(1, selection);
    std::set<vtkIdType> expected = { 5 };
    if (field == vtkSelectionNode::CELL)
    {
      vtkNew<vtkIdList> corners;
      plate->GetCellPoints(5, corners);
      expected = { corners->begin(), corners->end() };
    }
    const std::vector<double> found = run.Tolerances();
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_EQ(found[i], expected.count(static_cast<vtkIdType>(i)) == 1 ? 0.0 : -1.0) << i;
    }
    run->InvertedOn();
    EXPECT_EQ(Sum(run.Tolerances()), field == vtkSelectionNode::POINT ? -1.0 : 0.0);
  }
}

TEST(BoneTolerance, HoldsBoundariesAndFolds)
{
  ToleranceRun boundaries(Plate());
  boundaries->SetChoiceToBoundaries();
  boundaries->SetInsideTolerance(0.05);
  int onBoundary = 0;
  for (const double tolerance : boundaries.Tolerances())
  {
    onBoundary += tolerance == 0.05 ? 1 : 0;
  }
  EXPECT_EQ(onBoundary, 32);
  ToleranceRun folds(PolyData(Cube(4)));
  folds->SetChoiceToFolds();
  int onFold = 0;
  for (const double tolerance : folds.Tolerances())
  {
    onFold += tolerance == 0.0 ? 1 : 0;
  }
  EXPECT_EQ(onFold, 12 * 3 + 8);
  folds->SetFoldAngle(95.0);
  EXPECT_EQ(Largest(folds.Tolerances()), -1.0);
}

TEST(BoneTolerance, InARowTheSmallestCountsAndTheRestIsWhatNoFilterChose)
{
  ToleranceRun wide(Plate());
  wide->SetChoiceToImplicitFunction();
  wide->SetImplicitFunction(Ball(4.0, 4.0, 3.0));
  wide->SetInsideTolerance(0.3);
  ToleranceRun narrow(wide.Output());
  narrow->SetChoiceToImplicitFunction();
  narrow->SetImplicitFunction(Ball(4.0, 4.0, 1.0));
  narrow->SetInsideTolerance(0.05);
  ToleranceRun generous(narrow.Output());
  generous->SetInsideTolerance(9.0);
  ToleranceRun rest(narrow.Output());
  rest->SetChoiceToUnlimited();
  rest->SetInsideTolerance(0.1);
  const std::vector<double> capped = generous.Tolerances();
  const std::vector<double> found = rest.Tolerances();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const double* p = rest.Output()->GetPoint(static_cast<vtkIdType>(i));
    const double away = std::hypot(p[0] - 4.0, p[1] - 4.0);
    EXPECT_EQ(found[i], away <= 1.0 ? 0.05 : away <= 3.0 ? 0.3 : 0.1);
    EXPECT_EQ(capped[i], away <= 1.0 ? 0.05 : away <= 3.0 ? 0.3 : 9.0);
  }
}

TEST(BoneTolerance, LeavesItsInputAlone)
{
  vtkSmartPointer<vtkPolyData> plate = Plate();
  ToleranceRun first(plate);
  first->SetInsideTolerance(1.0);
  vtkPolyData* once = first.Output();
  ToleranceRun second(once);
  second.Output();
  EXPECT_EQ(plate->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(Largest(Values(once, "Tolerance")), 1.0);
}

TEST(BoneTolerance, SaysWhatIsMissing)
{
  const auto errors = [](void (*set)(vtkBoneTolerance*))
  {
    ToleranceRun run(Plate());
    set(run.operator->());
    run->Update();
    EXPECT_FALSE(run->GetOutput()->GetPointData()->HasArray("Tolerance"));
    return run.Errors;
  };
  EXPECT_EQ(errors([](vtkBoneTolerance* f) { f->SetChoiceToPointArray(); }), 1);
  EXPECT_EQ(errors([](vtkBoneTolerance* f) { f->SetChoiceToCellArray(); }), 1);
  EXPECT_EQ(errors([](vtkBoneTolerance* f) { f->SetChoiceToSelection(); }), 1);
  EXPECT_EQ(errors([](vtkBoneTolerance* f) { f->SetChoiceToImplicitFunction(); }), 1);
  EXPECT_EQ(errors([](vtkBoneTolerance* f) { f->SetFeather(1.0); }), 1); // towards no limit
  // At once, and again by the update.
  EXPECT_EQ(errors([](vtkBoneTolerance* f) { f->SetInsideTolerance(std::nan("")); }), 2);
}

TEST(BoneTolerance, IsModifiedByItsFunction)
{
  vtkSmartPointer<vtkSphere> ball = Ball(4.0, 4.0, 1.0);
  ToleranceRun run(Plate());
  run->SetChoiceToImplicitFunction();
  run->SetImplicitFunction(ball);
  const std::vector<double> before = run.Tolerances();
  ball->SetRadius(2.0);
  EXPECT_NE(run.Tolerances(), before);
}

TEST(BoneTolerance, PrintsEveryProperty)
{
  vtkNew<vtkBoneTolerance> filter;
  std::ostringstream stream;
  filter->Print(stream);
  for (const char* name :
    { "Choice:", "ChoiceArrayName:", "Labels:", "ImplicitFunction:", "FoldAngle:", "Inverted:",
      "InsideTolerance:", "OutsideTolerance:", "Feather:", "ToleranceArrayName:" })
  {
    EXPECT_NE(stream.str().find(name), std::string::npos) << name;
  }
}

TEST(BoneTolerance, RejectsArraysOfAnotherLength)
{
  for (const int difference : { -3, 3 })
  {
    const auto errors = [difference](const char* name, bool ofCells)
    {
      const vtkSmartPointer<vtkPolyData> plate = Plate();
      vtkNew<vtkFloatArray> array;
      array->SetName(name);
      array->SetNumberOfValues(
        (ofCells ? plate->GetNumberOfCells() : plate->GetNumberOfPoints()) + difference);
      array->Fill(1.0);
      vtkFieldData* data =
        ofCells ? static_cast<vtkFieldData*>(plate->GetCellData()) : plate->GetPointData();
      data->AddArray(array);
      ToleranceRun run(plate);
      run->SetChoice(ofCells ? vtkBoneTolerance::CELL_ARRAY : vtkBoneTolerance::POINT_ARRAY);
      run->Update();
      EXPECT_EQ(run->GetOutput()->GetNumberOfPoints(), 0);
      return run.Errors;
    };
    EXPECT_EQ(errors("Choice", false), 1);
    EXPECT_EQ(errors("Choice", true), 1);
    EXPECT_EQ(errors("Tolerance", false), 1);
  }
}

TEST(BoneTolerance, RejectsCellsWithAPointThatIsNotThere)
{
  for (const int choice : { vtkBoneTolerance::EVERYTHING, vtkBoneTolerance::CELL_ARRAY,
         vtkBoneTolerance::FOLDS, vtkBoneTolerance::BOUNDARIES })
  {
    const vtkSmartPointer<vtkPolyData> plate = Plate();
    plate->GetPolys()->InsertNextCell({ 0, 1, 50000000 });
    vtkNew<vtkFloatArray> array;
    array->SetName("Choice");
    array->SetNumberOfValues(plate->GetPolys()->GetNumberOfCells());
    array->Fill(1.0);
    plate->GetCellData()->AddArray(array);
    ToleranceRun run(plate);
    run->SetChoice(choice);
    run->Update();
    EXPECT_EQ(run.Errors, 1);
    EXPECT_EQ(run->GetOutput()->GetNumberOfPoints(), 0);
  }
}
