// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The removed components and the diagnostics in the results of the filter.
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A sphere and a cube of 2 mm, which has 12 triangles and 8 points.
vtkSmartPointer<vtkPolyData> BoneWithCrumb()
{
  return PolyData(Together(Icosphere(3, 10.0), Moved(Scaled(Cube(1), 2.0), { 30.0, 0.0, 0.0 })));
}
}

TEST(FilterPrune, IsOffAndThenListsWhatWent)
{
  FilterRun all(BoneWithCrumb());
  EXPECT_EQ(all.Value("output.components"), 2.0);
  EXPECT_TRUE(std::isnan(all.Value("pruned.components")));
  FilterRun run(BoneWithCrumb());
  run->SetPruneSize(5.0);
  run->SetMakeMaps(true);
  EXPECT_EQ(run.Value("output.components"), 1.0);
  EXPECT_EQ(run.Value("pruned.list.0.triangles"), 12.0);
  EXPECT_EQ(run.Value("pruned.list.0.size"), 2.0);
  EXPECT_EQ(run.Value("pruned.list.0.center.0"), 31.0);
  EXPECT_EQ(run->GetReportEntryUnit("pruned.list.0.area"), "mm2");
  vtkDataArray* map = run.InputCopy()->GetPointData()->GetArray("ResultPointIds");
  ASSERT_NE(map, nullptr);
  EXPECT_EQ(map->GetComponent(map->GetNumberOfTuples() - 1, 0), -1.0);
  EXPECT_GE(map->GetComponent(0, 0), 0.0);
}

TEST(FilterPrune, OfEverythingIsAnErrorWithoutOutput)
{
  FilterRun run(BoneWithCrumb());
  run->SetPruneTriangles(100000);
  EXPECT_EQ(run.Output()->GetNumberOfCells(), 0);
  EXPECT_EQ(run.Said("each of the 2 components"), 1) << run.AllMessages();
}

TEST(FilterPrune, TheListOfAnEarlierRunIsNotHandedOn)
{
  FilterRun first(BoneWithCrumb());
  first->SetPruneSize(5.0);
  FilterRun second(first.Output());
  EXPECT_TRUE(std::isnan(second.Value("pruned.components")));
  EXPECT_EQ(second.Value("input.components"), 1.0);
}

TEST(FilterExamination, IsOffAndThenInFieldDataAndGetters)
{
  const vtkSmartPointer<vtkPolyData> grid = PolyData(Grid(6));
  FilterRun without(grid);
  EXPECT_TRUE(std::isnan(without.Value("diagnostics.0.count")));
  FilterRun run(grid);
  run->SetDiagnoseInput(true);
  EXPECT_EQ(run.Value("diagnostics.0.count"), 24.0);
  EXPECT_EQ(run->GetReportText("diagnostics.0.kind"), "open_edges");
  EXPECT_EQ(run.Value("diagnostics.0.count"), 24.0);
  EXPECT_EQ(run.Value("diagnostics.0.first_triangles.0"), 0.0);
  EXPECT_TRUE(std::isnan(run.Value("diagnostics.0.first_triangles.8")));
}
