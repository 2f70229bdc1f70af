// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkBoneDecimate takes labels from arrays of cells or points, and every output triangle has the
// label of its position.
#include "FilterRun.h"
#include "VtkSurfaces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Tuple = std::array<int, 2>;

Vector3 MiddleOf(vtkPolyData* surface, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  surface->GetCellPoints(cell, ids);
  Vector3 sum = Vector3::Zero();
  for (vtkIdType i = 0; i < 3; ++i)
  {
    Vector3 p;
    surface->GetPoint(ids->GetId(i), p.data());
    sum += p / 3.0;
  }
  return sum;
}

double AreaOf(vtkPolyData* surface, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  surface->GetCellPoints(cell, ids);
  std::array<Vector3, 3> p;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    surface->GetPoint(ids->GetId(i), p.at(static_cast<std::size_t>(i)).data());
  }
  return 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
}

/// (1, 5) above, (1, 0) and (2, 0) below.
Tuple LabelAt(const Vector3& p)
{
  return p[2] > 2.0 ? Tuple{ 1, 5 } : p[0] > 0.0 ? Tuple{ 1, 0 } : Tuple{ 2, 0 };
}

void AddCellLabels(vtkPolyData* surface)
{
  vtkNew<vtkShortArray> labels;
  labels->SetName("BoundaryLabels");
  labels->SetNumberOfComponents(2);
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    const Tuple label = LabelAt(MiddleOf(surface, cell));
    labels->InsertNextTuple2(label[0], label[1]);
  }
  surface->GetCellData()->AddArray(labels);
}
}

TEST(LabelArray, OfCellsComesOutOnTheSideOfItsLines)
{
  const auto input = Sphere(4);
  AddCellLabels(input);
  FilterRun run(input);
  run->SetTargetReduction(0.9);
  run->SetLabelArrayName("BoundaryLabels");
  vtkPolyData* output = run.Output();
  EXPECT_TRUE(run.Errors.empty()) << run.AllMessages();
  EXPECT_EQ(run.Value("labels.count"), 3);
  EXPECT_LT(run.Value("labels.largest_change"), 0.05);
  EXPECT_EQ(CountWithVtk(output).BoundaryEdges, 0);
  vtkDataArray* labels = output->GetCellData()->GetArray("BoundaryLabels");
  ASSERT_NE(labels, nullptr);
  std::map<Tuple, double> areas; // mm2
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const Tuple label = { static_cast<int>(labels->GetComponent(cell, 0)),
      static_cast<int>(labels->GetComponent(cell, 1)) };
    areas[label] += AreaOf(output, cell);
    const Vector3 p = MiddleOf(output, cell);
    EXPECT_TRUE(label == LabelAt(p) || std::abs(p[2] - 2.0) < 2.0 || std::abs(p[0]) < 2.0);
  }
  EXPECT_NEAR((areas[{ 1, 5 }]), run.Value("labels.of_1_5.output_area"), 1e-3);
  EXPECT_NEAR((areas[{ 1, 0 }]), run.Value("labels.of_1_0.output_area"), 1e-3);
  EXPECT_NEAR((areas[{ 2, 0 }]), run.Value("labels.of_2_0.output_area"), 1e-3);
}

TEST(LabelArray, IsChosenByInputArrayToProcessUnlessThereIsAName)
{
  const auto input = Sphere(4);
  AddCellLabels(input);
  const auto labels = [&](const char* name, const char* processed)
  {
    FilterRun run(input);
    run->SetLabelArrayName(name);
    run->SetInputArrayToProcess(
      vtkBoneDecimate::LABEL_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, processed);
    return run.Value("labels.count");
  };
  EXPECT_EQ(labels("", "BoundaryLabels"), 3);
  EXPECT_EQ(labels("BoundaryLabels", "Nothing"), 3);
}

TEST(LabelArray, OfPointsIsTakenByMajority)
{
  const auto input = Sphere(3);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Bone");
  for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
  {
    labels->InsertNextValue(input->GetPoint(point)[2] > 0.3 ? 7 : -2);
  }
  input->GetPointData()->AddArray(labels);
  FilterRun run(input);
  run->SetTargetReduction(0.8);
  run->SetLabelArrayName("Bone");
  run.Output();
  EXPECT_TRUE(run.Errors.empty()) << run.AllMessages();
  EXPECT_EQ(run.Value("labels.count"), 2);
  EXPECT_NEAR(run.Value("labels.of_7.input_area") + run.Value("labels.of_-2.input_area"),
    run.Value("input.area"), 1e-6);
}

TEST(LabelArray, ThatIsNotThereOrHoldsNoWholeNumbersIsAnError)
{
  const auto input = Sphere(2);
  vtkNew<vtkDoubleArray> density;
  density->SetName("Density");
  for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
  {
    density->InsertNextValue(0.5 * static_cast<double>(point));
  }
  input->GetPointData()->AddArray(density);
  for (const char* name : { "Density", "Nonsense" })
  {
    FilterRun run(input);
    run->SetLabelArrayName(name);
    run.Output();
    EXPECT_EQ(run.Said("no cell or point array '" + std::string(name) + "'"), 1)
      << run.AllMessages();
  }
}
