// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkBoneSmooth keeps triangles and arrays, and its displacement is what a locator finds.
#include "LabelShapes.h"
#include "VtkSurfaces.h"

#include "vtkBoneDecimate.h"
#include "vtkBoneSmooth.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace bonedecimate::testsupport;

namespace
{
vtkSmartPointer<vtkPolyData> Torus()
{
  static const BinarySurface torus =
    MarchedShape(Oblique(TorusShape(6.0, 2.5)), 9.5, { 0.5, 0.5, 0.5 });
  return PolyData(torus.Surface, VTK_FLOAT);
}

vtkSmartPointer<vtkDoubleArray> Tolerances(vtkPolyData* surface)
{
  auto tolerances = vtkSmartPointer<vtkDoubleArray>::New();
  tolerances->SetName("Allowed");
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    tolerances->InsertNextValue(surface->GetPoint(p)[0] < 0.0 ? 0.0 : -1.0);
  }
  return tolerances;
}
}

TEST(BoneSmooth, KeepsAllTrianglesWithinHalfAVoxel)
{
  const vtkSmartPointer<vtkPolyData> input = Torus();
  vtkNew<vtkBoneSmooth> smooth;
  smooth->SetInputData(input);
  smooth->Update();
  vtkPolyData* output = smooth->GetOutput();
  EXPECT_EQ(output->GetNumberOfPolys(), input->GetNumberOfPolys());
  EXPECT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  EXPECT_EQ(WhatIsWrongWith(output), "");
  const std::vector<double> there = LocatorDistances(output, input);
  EXPECT_LE(Largest(there), 0.25);
  EXPECT_GT(smooth->GetReportValue("smoothing.largest_displacement"), 0.16);
  EXPECT_EQ(smooth->GetProofStatusAsString(), "proved");
  EXPECT_LE(smooth->GetProvedError(), 0.25 + 1e-6);
  EXPECT_EQ(smooth->GetReportText("smoothing.surface"), "binary");
  EXPECT_LT(smooth->GetReportValue("smoothing.angle_after"),
    smooth->GetReportValue("smoothing.angle_before"));
}

TEST(BoneSmooth, KeepsItsBound)
{
  vtkNew<vtkBoneSmooth> smooth;
  smooth->SetInputData(Torus());
  smooth->SetSmoothing(0.05);
  smooth->Update();
  EXPECT_LE(Largest(LocatorDistances(smooth->GetOutput(), Torus())), 0.05);
  EXPECT_LE(smooth->GetProvedError(), 0.05);
  smooth->SetSmoothing(0.0);
  smooth->SetMaximumError(0.06);
  smooth->Update();
  EXPECT_NEAR(smooth->GetReportValue("smoothing.bound"), 0.02, 1e-9);
}

TEST(BoneSmooth, KeepsPointsOfToleranceZeroAndPassesArrays)
{
  const vtkSmartPointer<vtkPolyData> input = Torus();
  input->GetPointData()->AddArray(Tolerances(input));
  vtkNew<vtkBoneSmooth> smooth;
  smooth->SetInputData(input);
  smooth->SetToleranceArrayName("Allowed");
  smooth->Update();
  vtkPolyData* output = smooth->GetOutput();
  const std::vector<double> passed = Values(output, "Allowed");
  ASSERT_EQ(passed.size(), static_cast<std::size_t>(output->GetNumberOfPoints()));
  const std::vector<double> distances = LocatorDistances(output, input);
  EXPECT_GT(Largest(distances), 0.1);
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    if (output->GetPoint(p)[0] < -0.5)
    {
      EXPECT_LT(distances[static_cast<std::size_t>(p)], 1e-6);
    }
  }
}

TEST(BoneSmooth, GivesWhatARunWithoutReductionGives)
{
  vtkNew<vtkBoneSmooth> smooth;
  smooth->SetInputData(Torus());
  smooth->SetSmoothing(0.2);
  smooth->Update();
  vtkNew<vtkBoneDecimate> decimate;
  decimate->SetInputData(Torus());
  decimate->SetSmoothing(0.2);
  decimate->SetTargetReduction(0.0);
  decimate->Update();
  ASSERT_EQ(smooth->GetOutput()->GetNumberOfPoints(), decimate->GetOutput()->GetNumberOfPoints());
  for (vtkIdType p = 0; p < smooth->GetOutput()->GetNumberOfPoints(); ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(smooth->GetOutput()->GetPoint(p)[k], decimate->GetOutput()->GetPoint(p)[k]);
    }
  }
}

TEST(BoneSmooth, KeepsSharpEdgesByTheirAngle)
{
  const BinarySurface cube =
    MarchedShape(Oblique(BoxShape({ 3.5, 3.5, 3.5 })), 6.5, { 0.5, 0.5, 0.5 });
  vtkNew<vtkBoneSmooth> smooth;
  smooth->SetInputData(PolyData(cube.Surface, VTK_FLOAT));
  smooth->Update();
  EXPECT_EQ(smooth->GetReportValue("smoothing.sharp_points"), 0.0);
  smooth->SetFeatureAngle(45.0);
  smooth->Update();
  EXPECT_GT(smooth->GetReportValue("smoothing.sharp_points"), 100.0);
  EXPECT_LE(smooth->GetProvedError(), 0.25 + 1e-6);
}

TEST(BoneSmooth, RejectsValuesOutOfRange)
{
  vtkNew<vtkBoneSmooth> smooth;
  smooth->SetInputData(Torus());
  smooth->GlobalWarningDisplayOff();
  smooth->SetSmoothing(-1.0);
  EXPECT_EQ(smooth->GetSmoothing(), 0.0);
  EXPECT_NE(smooth->GetRejectedValue("Smoothing"), "");
  smooth->Update();
  EXPECT_EQ(smooth->GetOutput()->GetNumberOfPolys(), 0);
  smooth->GlobalWarningDisplayOn();
}
