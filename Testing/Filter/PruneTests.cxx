// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What was left out on request, and what the doctor found, as the filter hands it out.
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

double Field(vtkPolyData* surface, const std::string& name)
{
  vtkDataArray* array = surface->GetFieldData()->GetArray(("bonedecimate." + name).c_str());
  return array ? array->GetComponent(0, 0) : std::nan("");
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
  EXPECT_EQ(run.Value("pruned.list.0.faces"), 12.0);
  EXPECT_EQ(Field(run.Output(), "pruned.list.0.size"), 2.0);
  EXPECT_EQ(Field(run.Output(), "pruned.list.0.place.0"), 31.0);
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
  EXPECT_TRUE(std::isnan(Field(second.Output(), "pruned.components")));
  EXPECT_EQ(Field(second.Output(), "input.components"), 1.0);
}

TEST(FilterExamination, IsOffAndThenInFieldDataAndGetters)
{
  const vtkSmartPointer<vtkPolyData> grid = PolyData(Grid(6));
  FilterRun without(grid);
  EXPECT_TRUE(std::isnan(without.Value("findings.0.count")));
  FilterRun run(grid);
  run->SetExamineInput(true);
  EXPECT_EQ(run.Value("findings.0.count"), 24.0);
  EXPECT_EQ(run->GetReportText("findings.0.kind"), "open_edges");
  EXPECT_EQ(Field(run.Output(), "findings.0.count"), 24.0);
  EXPECT_EQ(run.Value("findings.0.first_triangles.0"), 0.0);
  EXPECT_TRUE(std::isnan(run.Value("findings.0.first_triangles.8")));
}
