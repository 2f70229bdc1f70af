// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkBoneDiagnostics.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate::testsupport;

namespace
{
int NumberOf(vtkBoneDiagnostics* check, const std::string& word)
{
  for (int i = 0; i < check->GetNumberOfDiagnostics(); ++i)
  {
    if (check->GetWord(i) == word)
    {
      return i;
    }
  }
  return -1;
}
}

TEST(Check, PassesTheSurfaceOnAndFindsNothingWrong)
{
  const vtkSmartPointer<vtkPolyData> input = Sphere(3);
  vtkNew<vtkBoneDiagnostics> check;
  check->SetInputData(input);
  check->Update();
  EXPECT_EQ(check->GetOutput()->GetPoints(), input->GetPoints());
  EXPECT_TRUE(check->IsUsable());
  ASSERT_EQ(check->GetNumberOfDiagnostics(), 1);
  EXPECT_EQ(check->GetWord(0), "components");
  EXPECT_EQ(check->GetSeverity(0), "note");
  EXPECT_EQ(check->GetCount(0), 1);
}

TEST(Check, NamesCellsAndNotTheTrianglesThatTheyWereCutInto)
{
  const vtkSmartPointer<vtkPolyData> input = PolyData(Grid(2));
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 4, 3 });
  polygons->InsertNextCell({ 1, 2, 5, 4 });
  polygons->InsertNextCell({ 1, 2, 5, 4 });
  input->SetPolys(polygons);
  vtkNew<vtkBoneDiagnostics> check;
  check->SetInputData(input);
  check->Update();
  const int duplicates = NumberOf(check, "duplicates");
  ASSERT_GE(duplicates, 0);
  EXPECT_EQ(check->GetIdsOf(duplicates), "cell");
  vtkNew<vtkIdList> ids;
  check->GetFirstIds(duplicates, ids);
  ASSERT_EQ(ids->GetNumberOfIds(), 1);
  EXPECT_EQ(ids->GetId(0), 2);
}

TEST(Check, ReportsWhatDecimationRejects)
{
  bonedecimate::Surface surface = Icosphere(2, 10.0);
  surface.Points[11][0] = NAN;
  vtkNew<vtkBoneDiagnostics> check;
  check->SetInputData(PolyData(surface));
  check->Update();
  EXPECT_FALSE(check->IsUsable());
  const int found = NumberOf(check, "non_finite_points");
  ASSERT_GE(found, 0);
  EXPECT_EQ(check->GetSeverity(found), "rejected");
  EXPECT_TRUE(std::isnan(check->GetLength(found)));
}

TEST(Check, ReturnsNothingForNumbersOutOfRange)
{
  vtkNew<vtkBoneDiagnostics> check;
  vtkNew<vtkIdList> ids;
  ids->InsertNextId(5);
  check->GetFirstIds(3, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 0);
  EXPECT_EQ(check->GetWord(-1), "");
  EXPECT_EQ(check->GetCount(0), 0);
}
