// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// ModelGrid of vtkBoneSurfaces: the surface of the map of a network, and the filters that compare
// it with the copy.
#include "FilterRun.h"
#include "LabelImages.h"
#include "RejectionWalk.h"

#include "vtkBoneDecimate.h"
#include "vtkBoneVoxelCheck.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr Index Samples = 41;
constexpr double Length = 2.25; // layers per sample

/// Two uneven bodies on the grid of a network.
int LabelOfSample(const std::array<Index, 3>& v)
{
  const Vector3 p(v[0], v[1], v[2]);
  const double waves = 2.0 * std::sin(0.5 * p[0]) * std::cos(0.4 * p[1]) * std::sin(0.3 * p[2]);
  const double first = (p - Vector3(13.0, 15.0, 18.0)).norm() + waves;
  const double second = (p - Vector3(27.0, 24.0, 21.0)).norm() + waves;
  return first < 11.0 ? 1 : second < 11.0 ? 2 : 0;
}

LabelMap MapOfNetwork()
{
  return MakeLabelMap({ Samples, Samples, Samples }, LabelOfSample);
}

/// Its copy to smaller voxels, corners aligned.
LabelMap MapOfFile()
{
  constexpr auto layers = static_cast<Index>((Samples - 1) * Length + 1.0);
  return MakeLabelMap({ layers, layers, layers },
    [&](const std::array<Index, 3>& v)
    {
      std::array<Index, 3> sample;
      for (std::size_t k = 0; k < 3; ++k)
      {
        sample[k] = static_cast<Index>(v[k] * (Samples - 1.0) / (layers - 1.0) + 0.5);
      }
      return LabelOfSample(sample);
    });
}

vtkSmartPointer<vtkPolyData> ExtractedWith(vtkImageData* image, const char* choice)
{
  const vtkNew<vtkBoneSurfaces> filter;
  filter->SetInputData(image);
  filter->SetModelGrid(choice);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  EXPECT_EQ(filter->GetModelGridFound().empty(), std::string(choice) == "off");
  return filter->GetOutput();
}
}

TEST(ModelGridOfFilters, HasTheSurfaceOfTheMapOfTheNetwork)
{
  const vtkSmartPointer<vtkImageData> file = ImageOf(MapOfFile());
  LabelMap network = MapOfNetwork();
  network.Grid.Spacing *= Length;
  const vtkSmartPointer<vtkPolyData> expected = ExtractedWith(ImageOf(network), "off");
  for (const char* choice : { "auto", "2.25", "2.25,2.25,2.25" })
  {
    const vtkSmartPointer<vtkPolyData> found = ExtractedWith(file, choice);
    ASSERT_EQ(found->GetNumberOfPoints(), expected->GetNumberOfPoints());
    EXPECT_EQ(LabelsOf(found), LabelsOf(expected));
    for (vtkIdType p = 0; p < found->GetNumberOfPoints(); ++p)
    {
      EXPECT_LT((Vector3(found->GetPoint(p)) - Vector3(expected->GetPoint(p))).norm(), 1e-9);
    }
  }
  EXPECT_GT(ExtractedWith(file, "off")->GetNumberOfPoints(), 3 * expected->GetNumberOfPoints());
}

TEST(ModelGridOfFilters, RejectsASpacingThatDoesNotFit)
{
  const vtkNew<vtkBoneSurfaces> filter;
  ErrorTexts errors(filter.Get());
  filter->SetInputData(ImageOf(MapOfFile()));
  filter->SetModelGrid("3");
  filter->Update();
  EXPECT_EQ(errors.Count("not a copy of one with the requested spacing"), 1);
  filter->SetModelGrid("coarse");
  EXPECT_NE(filter->GetRejectedValue("ModelGrid").find("takes auto, off"), std::string::npos);
  EXPECT_EQ(filter->GetModelGrid(), "3");
}

TEST(ModelGridOfFilters, IsComparedWithTheCopy)
{
  const vtkSmartPointer<vtkImageData> file = ImageOf(MapOfFile());
  const vtkNew<vtkBoneDecimate> decimate;
  decimate->SetInputData(ExtractedWith(file, "auto"));
  decimate->SetLabelMapData(file);
  decimate->AutomaticSmoothingOn();
  decimate->SetMaximumError(1.0);
  decimate->Update();
  EXPECT_EQ(decimate->GetReportValue("voxels.changed"), 0.0);
  const vtkNew<vtkBoneVoxelCheck> check;
  check->SetInputData(0, decimate->GetOutput());
  check->SetInputData(1, file);
  check->Update();
  EXPECT_EQ(check->GetNumberOfChangedVoxels(), 0);
  EXPECT_NE(check->GetModelGridFound(), "");
  EXPECT_GT(check->GetNumberOfChangedImageVoxels(), 0);
  EXPECT_GT(check->GetNumberOfComparedImageVoxels(), check->GetNumberOfComparedVoxels());
  check->SetInputData(0, ExtractedWith(file, "off"));
  check->Update();
  EXPECT_EQ(check->GetNumberOfChangedVoxels(), 0);
  EXPECT_EQ(check->GetModelGridFound(), "");
  EXPECT_EQ(check->GetNumberOfComparedImageVoxels(), 0);
}
