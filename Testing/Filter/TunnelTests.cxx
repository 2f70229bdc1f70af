// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Closed tunnels in the results of the filter.
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A plate of three tunnels with its x coordinates as a point array, and cells numbered by the half
/// in which they are.
vtkSmartPointer<vtkPolyData> PlateWithArrays()
{
  const Surface plate = DrilledPlate();
  vtkSmartPointer<vtkPolyData> data = PolyData(plate);
  vtkNew<vtkDoubleArray> x;
  x->SetName("X");
  for (const Vector3& point : plate.Points)
  {
    x->InsertNextValue(point[0]);
  }
  vtkNew<vtkIntArray> half;
  half->SetName("Half");
  for (const Triangle& corners : plate.Triangles)
  {
    half->InsertNextValue(plate.Points[static_cast<std::size_t>(corners[0])][0] < 11.0 ? 1 : 2);
  }
  data->GetPointData()->AddArray(x);
  data->GetCellData()->AddArray(half);
  return data;
}
}

TEST(FilterTunnels, AreClosedOnRequestWithArraysAndAWarning)
{
  FilterRun without(PlateWithArrays());
  EXPECT_TRUE(std::isnan(without.Value("tunnels.closed")));
  FilterRun run(PlateWithArrays());
  run->SetTunnelSize(4.0);
  run->SetTargetReduction(0.0);
  run->SetMakeMaps(true);
  EXPECT_EQ(run.Value("tunnels.closed"), 3.0);
  EXPECT_EQ(run.Value("tunnels.genus_after"), 0.0);
  EXPECT_EQ(run.Value("output.euler_number"), 2.0);
  EXPECT_EQ(run.Said("3 tunnels were closed"), 1) << run.AllMessages();
  vtkPolyData* output = run.Output();
  vtkDataArray* x = output->GetPointData()->GetArray("X");
  vtkDataArray* half = output->GetCellData()->GetArray("Half");
  ASSERT_NE(x, nullptr);
  ASSERT_NE(half, nullptr);
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> point = {};
    output->GetPoint(p, point.data());
    EXPECT_DOUBLE_EQ(x->GetComponent(p, 0), point[0]);
  }
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const double value = half->GetComponent(cell, 0);
    EXPECT_TRUE(value == 1.0 || value == 2.0);
  }
}

TEST(FilterTunnels, AreNotClosedWithAReference)
{
  FilterRun run(PlateWithArrays());
  run->SetTunnelSize(4.0);
  run->SetMaximumError(0.1);
  run->SetReferenceData(PlateWithArrays());
  EXPECT_EQ(run.Output()->GetNumberOfCells(), 0);
  EXPECT_EQ(run.Said("TunnelSize does not go with a reference"), 1) << run.AllMessages();
}
