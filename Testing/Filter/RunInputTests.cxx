// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkBoneDecimateLevels and vtkBoneErrorSearch take tolerances of points, labels of triangles and a
// reference.
#include "BruteForce.h"
#include "FilterRun.h"
#include "VtkSurfaces.h"

#include "vtkBoneDecimateLevels.h"
#include "vtkBoneErrorSearch.h"
#include "vtkBoneSurfaceDistance.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Position = std::array<double, 3>;

constexpr double Error = 0.3;    // mm
constexpr double NearLine = 1.5; // mm

std::set<Position> PointsOf(vtkPolyData* surface)
{
  std::set<Position> points;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Position p{};
    surface->GetPoint(i, p.data());
    points.insert(p);
  }
  return points;
}

/// 0 for points with negative x, no limit for others.
vtkSmartPointer<vtkPolyData> HalfConstrained()
{
  vtkSmartPointer<vtkPolyData> surface = Bumps(3);
  vtkNew<vtkDoubleArray> allowed;
  allowed->SetName("Allowed");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    allowed->InsertNextValue(surface->GetPoint(i)[0] < 0.0 ? 0.0 : -1.0);
  }
  surface->GetPointData()->AddArray(allowed);
  return surface;
}

int NumberOfLostPoints(vtkPolyData* before, vtkPolyData* after)
{
  const std::set<Position> points = PointsOf(after);
  int lost = 0;
  for (const Position& p : PointsOf(before))
  {
    lost += p[0] < 0.0 && points.count(p) == 0 ? 1 : 0;
  }
  return lost;
}

/// mm, of the middle of a triangle.
double HeightOf(vtkPolyData* surface, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  surface->GetCellPoints(cell, ids);
  double z = 0.0; // mm
  for (vtkIdType i = 0; i < 3; ++i)
  {
    z += surface->GetPoint(ids->GetId(i))[2] / 3.0;
  }
  return z;
}

vtkSmartPointer<vtkPolyData> TwoHalves()
{
  vtkSmartPointer<vtkPolyData> surface = Bumps(3);
  vtkNew<vtkIntArray> halves;
  halves->SetName("Half");
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    halves->InsertNextValue(HeightOf(surface, cell) > 0.0 ? 4 : 9);
  }
  surface->GetCellData()->AddArray(halves);
  return surface;
}

/// How many triangles of each half have its label; -1 if a triangle has the label of the other half
/// and is far from the line.
std::array<int, 2> TrianglesOfHalves(vtkPolyData* surface)
{
  std::array<int, 2> counts{};
  vtkDataArray* halves = surface->GetCellData()->GetArray("Half");
  for (vtkIdType cell = 0; halves != nullptr && cell < surface->GetNumberOfCells(); ++cell)
  {
    const auto label = static_cast<int>(halves->GetComponent(cell, 0));
    ++counts.at(label == 4 ? 0 : 1);
    const double height = HeightOf(surface, cell);
    if (label != (height > 0.0 ? 4 : 9) && std::abs(height) > NearLine)
    {
      return { -1, -1 };
    }
  }
  return counts;
}

double CertifiedDistance(vtkPolyData* reference, vtkPolyData* result)
{
  vtkNew<vtkBoneSurfaceDistance> distance;
  distance->SetInputData(0, reference);
  distance->SetInputData(1, result);
  distance->Update();
  return distance->GetUpperBound();
}

/// Bumps(3) within half of Error.
vtkSmartPointer<vtkPolyData> ResultOf(vtkPolyData* first)
{
  FilterRun run(first);
  run->SetMaximumError(0.5 * Error);
  vtkSmartPointer<vtkPolyData> result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(run.Output());
  return result;
}

/// A filter that counts its errors.
template <typename Filter>
class Counting
{
public:
  explicit Counting(vtkPolyData* surface)
  {
    this->Held->SetInputData(surface);
    this->Held->AddObserver(vtkCommand::ErrorEvent, this, &Counting::OnError);
    this->Held->AddObserver(vtkCommand::WarningEvent, this, &Counting::OnNothing);
    this->Held->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &Counting::OnNothing);
  }
  Filter* operator->() { return this->Held; }

  int Errors = 0;

private:
  void OnError(vtkObject*, unsigned long, void*) { ++this->Errors; }
  void OnNothing(vtkObject*, unsigned long, void*) {}

  vtkNew<Filter> Held;
};
}

TEST(RunInput, ConstrainedPointsStayInAllLevels)
{
  const auto input = HalfConstrained();
  Counting<vtkBoneDecimateLevels> levels(input);
  levels->MeasureDistancesOff();
  levels->SetToleranceArrayName("Allowed");
  levels->SetTargetNumberOfTriangles(900);
  for (const int triangles : { 1200, 900 })
  {
    levels->SetNumberOfTriangles(triangles);
    levels->Update();
    EXPECT_EQ(levels->GetOutput()->GetNumberOfPolys(), triangles);
    EXPECT_EQ(NumberOfLostPoints(input, levels->GetOutput()), 0);
  }
  levels->SetToleranceArrayName("");
  levels->Update();
  EXPECT_GT(NumberOfLostPoints(input, levels->GetOutput()), 0);
  EXPECT_EQ(levels.Errors, 0);
}

TEST(RunInput, ATriangleOfALevelHasItsLabel)
{
  const auto input = TwoHalves();
  Counting<vtkBoneDecimateLevels> levels(input);
  levels->MeasureDistancesOff();
  levels->SetLabelArrayName("Half");
  levels->SetTargetNumberOfTriangles(500);
  levels->SetNumberOfTriangles(700);
  levels->Update();
  EXPECT_EQ(levels->GetOutput()->GetNumberOfPolys(), 700);
  const std::array<int, 2> halves = TrianglesOfHalves(levels->GetOutput());
  EXPECT_GT(halves[0], 0);
  EXPECT_GT(halves[1], 0);
  EXPECT_EQ(CountWithVtk(levels->GetOutput()).BoundaryEdges, 0);
  EXPECT_EQ(levels.Errors, 0);
}

TEST(RunInput, ALogOfARunWithLabelsNeedsThem)
{
  const auto input = TwoHalves();
  Counting<vtkBoneDecimateLevels> levels(input);
  levels->MeasureDistancesOff();
  levels->SetLabelArrayName("Half");
  levels->Update();
  const Surface coarsest = SurfaceOf(levels->GetOutput());
  Counting<vtkBoneDecimateLevels> again(input);
  again->SetLog(levels->GetLog());
  again->SetLabelArrayName("Half");
  again->Update();
  EXPECT_EQ(again.Errors, 0);
  EXPECT_TRUE(SameBytes(SurfaceOf(again->GetOutput()), coarsest));
  again->SetLabelArrayName("");
  again->Update();
  EXPECT_EQ(again.Errors, 1);
}

TEST(RunInput, LevelsKeepTheErrorRelativeToTheReference)
{
  const vtkSmartPointer<vtkPolyData> first = Bumps(3);
  Counting<vtkBoneDecimateLevels> levels(ResultOf(first));
  levels->MeasureDistancesOff();
  levels->SetReferenceData(first);
  levels->Update();
  EXPECT_EQ(levels.Errors, 1) << "without a largest error";
  levels->SetMaximumError(Error);
  levels->Update();
  EXPECT_EQ(levels.Errors, 1);
  EXPECT_LE(CertifiedDistance(first, levels->GetOutput()), Error);
  EXPECT_GT(levels->GetReportValue("reference.triangles"), 0.0);
}

TEST(RunInput, AnArrayThatIsMissingIsAnError)
{
  for (const bool isOfLabels : { false, true })
  {
    Counting<vtkBoneDecimateLevels> levels(Bumps(3));
    Counting<vtkBoneErrorSearch> search(Bumps(3));
    search->AddError(Error);
    isOfLabels ? levels->SetLabelArrayName("None") : levels->SetToleranceArrayName("None");
    isOfLabels ? search->SetLabelArrayName("None") : search->SetToleranceArrayName("None");
    levels->Update();
    search->Update();
    EXPECT_EQ(levels.Errors, 1);
    EXPECT_EQ(search.Errors, 1);
  }
}

TEST(RunInput, HoldsInEveryRunOfASearch)
{
  const auto constrained = HalfConstrained();
  Counting<vtkBoneErrorSearch> search(constrained);
  search->SetToleranceArrayName("Allowed");
  search->SetTargetNumberOfTriangles(900);
  search->SetRelativePrecision(0.5);
  search->Update();
  EXPECT_LE(search->GetOutput()->GetNumberOfPolys(), 900);
  EXPECT_EQ(NumberOfLostPoints(constrained, search->GetOutput()), 0);
  EXPECT_EQ(search.Errors, 0);

  Counting<vtkBoneErrorSearch> curve(TwoHalves());
  curve->SetLabelArrayName("Half");
  curve->AddError(Error);
  curve->Update();
  const std::array<int, 2> halves = TrianglesOfHalves(curve->GetOutput());
  EXPECT_GT(halves[0], 0);
  EXPECT_GT(halves[1], 0);
  EXPECT_LT(halves[0] + halves[1], 1280);
}

TEST(RunInput, ASearchFindsTheErrorRelativeToTheReference)
{
  const vtkSmartPointer<vtkPolyData> first = Bumps(3);
  const vtkSmartPointer<vtkPolyData> input = ResultOf(first);
  Counting<vtkBoneErrorSearch> search(input);
  search->SetReferenceData(first);
  search->SetTargetNumberOfTriangles(static_cast<int>(input->GetNumberOfPolys()) * 4 / 5);
  search->SetRelativePrecision(0.5);
  search->Update();
  EXPECT_EQ(search.Errors, 0);
  const double found = search->GetSmallestError();
  const double proved = CertifiedDistance(first, search->GetOutput());
  EXPECT_LE(proved, 1.001 * found);
  EXPECT_GE(proved, 0.95 * found);
  EXPECT_GE(found, 0.95 * CertifiedDistance(first, input)) << "no result is nearer than the input";
}
