// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// A label map beside a surface that does not carry its grid, in every filter that runs a
// decimation.
#include "LabelImages.h"
#include "RejectionWalk.h"
#include "VtkSurfaces.h"

#include "vtkBoneDecimate.h"
#include "vtkBoneDecimateLevels.h"
#include "vtkBoneErrorSearch.h"
#include "vtkBoneSmooth.h"
#include "vtkBoneVoxelCheck.h"
#include "vtkCommand.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// One label, 7, on an oblique grid.
LabelMap OneLabel()
{
  LabelMap map = EllipsoidLabels({ 25, 22, 20 });
  map.Grid = ObliqueGrid({ 25, 22, 20 }, false);
  for (std::int32_t& label : map.Labels)
  {
    label = label != 0 ? 7 : 0;
  }
  return map;
}

/// As another program would hand it over: points and triangles, in single precision.
vtkSmartPointer<vtkPolyData> Bare(vtkImageData* image)
{
  const vtkSmartPointer<vtkPolyData> surface = Extracted(image, vtkAlgorithm::SINGLE_PRECISION);
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->SetPoints(surface->GetPoints());
  bare->SetPolys(surface->GetPolys());
  return bare;
}

vtkTypeInt64 ChangedVoxels(vtkPolyData* surface, vtkImageData* image)
{
  vtkNew<vtkBoneVoxelCheck> check;
  check->SetInputData(0, surface);
  check->SetInputData(1, image);
  check->Update();
  EXPECT_GT(check->GetNumberOfComparedVoxels(), 0);
  return check->GetNumberOfChangedVoxels();
}

struct Warnings
{
  void OnWarning(vtkObject*, unsigned long, void* text) { this->Text += static_cast<char*>(text); }
  std::string Text;
};

/// What a filter says of a surface and a map, the first error.
template <typename Filter>
std::string ErrorOf(Filter* filter, vtkPolyData* surface, vtkImageData* image)
{
  ErrorTexts errors(filter);
  filter->SetInputData(surface);
  filter->SetLabelMapData(image);
  filter->Update();
  return errors.Texts.empty() ? std::string() : errors.Texts.front();
}
}

TEST(LabelMapOfRun, KeepsTheVoxelsOfASurfaceWithoutArrays)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(OneLabel(), VTK_SHORT, { 3, -2, 1 });
  const vtkSmartPointer<vtkPolyData> surface = Bare(image);
  for (const int keep : { 0, 1 })
  {
    vtkNew<vtkBoneDecimate> decimate;
    decimate->SetKeepVoxels(keep);
    decimate->SetTargetNumberOfTriangles(60);
    EXPECT_EQ(ErrorOf(decimate.Get(), surface, image), "");
    const vtkTypeInt64 changed = ChangedVoxels(decimate->GetOutput(), image);
    EXPECT_EQ(changed == 0, keep == 1);
    EXPECT_EQ(decimate->GetReportValue("voxels.changed"), static_cast<double>(changed));
    EXPECT_EQ(decimate->GetReportText("voxels.guard"), keep == 1 ? "on" : "off");
    EXPECT_GT(decimate->GetReportValue("voxels.of_7.voxels"), 0.0);
  }
}

TEST(LabelMapOfRun, SmoothsASurfaceWithoutArraysAsOneWithThem)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(OneLabel());
  vtkNew<vtkBoneSmooth> bare;
  EXPECT_EQ(ErrorOf(bare.Get(), Bare(image), image), "");
  EXPECT_EQ(bare->GetReportText("smoothing.surface"), "label_map");
  EXPECT_GT(bare->GetReportValue("smoothing.largest_displacement"), 0.1);
  EXPECT_EQ(bare->GetReportValue("voxels.changed"), 0.0);
  EXPECT_EQ(ChangedVoxels(bare->GetOutput(), image), 0);
  vtkNew<vtkBoneSmooth> whole;
  whole->SetInputData(Extracted(image, vtkAlgorithm::SINGLE_PRECISION));
  whole->Update();
  ASSERT_EQ(whole->GetOutput()->GetNumberOfPoints(), bare->GetOutput()->GetNumberOfPoints());
  for (vtkIdType p = 0; p < whole->GetOutput()->GetNumberOfPoints(); ++p)
  {
    const Vector3 a(whole->GetOutput()->GetPoint(p));
    ASSERT_LT((a - Vector3(bare->GetOutput()->GetPoint(p))).norm(), 1e-4);
  }
}

TEST(LabelMapOfRun, SmoothsSeveralLabelsByTheArraysOfTheSurface)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(EllipsoidLabels({ 25, 22, 20 }));
  vtkNew<vtkBoneSmooth> smooth;
  smooth->SetInputData(Extracted(image));
  smooth->Update();
  EXPECT_EQ(smooth->GetReportText("smoothing.surface"), "label_map");
  EXPECT_GT(smooth->GetReportValue("smoothing.largest_displacement"), 0.1);
  EXPECT_EQ(ChangedVoxels(smooth->GetOutput(), image), 0);
  EXPECT_FALSE(smooth->GetOutput()->GetPointData()->HasArray("GridPoint"));
}

TEST(LabelMapOfRun, RejectsWhatContradictsItself)
{
  const LabelMap map = OneLabel();
  const vtkSmartPointer<vtkImageData> image = ImageOf(map);
  const vtkSmartPointer<vtkPolyData> bare = Bare(image);
  LabelMap moved = map;
  moved.Grid.Origin[0] += 0.1;
  const auto errorOf = [](vtkPolyData* surface, vtkImageData* of, int label = 0)
  {
    vtkNew<vtkBoneDecimate> decimate;
    decimate->SetLabel(label);
    return ErrorOf(decimate.Get(), surface, of);
  };
  EXPECT_NE(errorOf(Extracted(image), ImageOf(moved)).find("grid"), std::string::npos);
  EXPECT_EQ(errorOf(Extracted(image), image), "");
  EXPECT_NE(errorOf(Extracted(image), image, 7).find("BoundaryLabels"), std::string::npos);
  EXPECT_NE(errorOf(bare, image, 8).find("label 8"), std::string::npos);
  EXPECT_NE(errorOf(bare, nullptr, 7).find("label map"), std::string::npos);
  const vtkSmartPointer<vtkImageData> several = ImageOf(EllipsoidLabels({ 25, 22, 20 }));
  EXPECT_NE(errorOf(bare, several).find("1, 2, 3"), std::string::npos);
}

TEST(LabelMapOfRun, SmoothsNoSurfaceWhosePointsWereMoved)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(OneLabel());
  vtkNew<vtkBoneSmooth> smooth;
  EXPECT_EQ(ErrorOf(smooth.Get(), Bare(image), image), "");
  const vtkSmartPointer<vtkPolyData> smoothed = smooth->GetOutput();
  vtkNew<vtkBoneSmooth> again;
  EXPECT_NE(
    ErrorOf(again.Get(), smoothed, image).find("smoothing can keep voxels"), std::string::npos);
  vtkNew<vtkBoneDecimate> keeping;
  keeping->SetSmoothing(0.2);
  keeping->SetKeepVoxels(vtkBoneDecimate::KEEP_VOXELS_ON);
  EXPECT_NE(
    ErrorOf(keeping.Get(), smoothed, image).find("smoothing can keep voxels"), std::string::npos);
  keeping->SetSmoothing(0.0);
  EXPECT_EQ(ErrorOf(keeping.Get(), smoothed, image), "");
  EXPECT_EQ(ChangedVoxels(keeping->GetOutput(), image), 0);
}

TEST(LabelMapOfRun, WarnsOfASurfaceOfAnotherMap)
{
  LabelMap map = OneLabel();
  const vtkSmartPointer<vtkPolyData> surface = Bare(ImageOf(map));
  map.Labels.front() = 7;
  const vtkSmartPointer<vtkImageData> image = ImageOf(map);
  vtkNew<vtkBoneDecimate> decimate;
  Warnings warnings;
  decimate->AddObserver(vtkCommand::WarningEvent, &warnings, &Warnings::OnWarning);
  EXPECT_EQ(ErrorOf(decimate.Get(), surface, image), "");
  EXPECT_NE(warnings.Text.find("gives 1 of the voxels another label"), std::string::npos)
    << warnings.Text;
  EXPECT_EQ(decimate->GetReportValue("voxels.of_7.lost"), 1.0);
}

TEST(LabelMapOfRun, LevelsKeepEveryVoxelOfSeveralLabels)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(EllipsoidLabels({ 25, 22, 20 }));
  vtkNew<vtkBoneDecimateLevels> levels;
  Warnings warnings;
  levels->AddObserver(vtkCommand::WarningEvent, &warnings, &Warnings::OnWarning);
  levels->MeasureDistancesOff();
  levels->SetInputData(Extracted(image));
  levels->SetTargetNumberOfTriangles(50);
  vtkTypeInt64 most = 0;
  for (const int keep : { 0, 1 })
  {
    levels->SetKeepVoxels(keep);
    levels->Update();
    ASSERT_GT(levels->GetNumberOfMarks(), 2);
    most = 0;
    for (int mark = 0; mark < levels->GetNumberOfMarks(); ++mark)
    {
      levels->SetNumberOfTriangles(levels->GetMarkTriangles(mark));
      levels->Update();
      EXPECT_EQ(ChangedVoxels(levels->GetOutput(), image), levels->GetMarkChangedVoxels(mark));
      most = std::max(most, levels->GetMarkChangedVoxels(mark));
    }
    levels->SetNumberOfTriangles(0);
    EXPECT_EQ(most == 0, keep == 1);
  }
  EXPECT_NE(warnings.Text.find("curves between labels do not change"), std::string::npos);
  EXPECT_EQ(levels->GetMarkChangedVoxels(levels->GetNumberOfMarks()), -1);
  vtkNew<vtkBoneDecimateLevels> read;
  read->SetInputData(Extracted(image));
  read->SetLog(levels->GetLog());
  read->Update();
  ASSERT_EQ(read->GetNumberOfMarks(), levels->GetNumberOfMarks());
  EXPECT_EQ(read->GetMarkChangedVoxels(0), 0);
  EXPECT_EQ(ChangedVoxels(read->GetOutput(), image), 0);
}

TEST(LabelMapOfRun, CurvesTellTheVoxelsOfEachRun)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(OneLabel());
  for (const int keep : { 0, 1 })
  {
    vtkNew<vtkBoneErrorSearch> curve;
    curve->SetMode(vtkBoneDecimate::FAST);
    curve->SetKeepVoxels(keep);
    curve->AddError(1.5);
    EXPECT_EQ(ErrorOf(curve.Get(), Bare(image), image), "");
    const vtkTypeInt64 changed = ChangedVoxels(curve->GetOutput(), image);
    EXPECT_EQ(curve->GetTrials()->GetValueByName(0, "ChangedVoxels").ToTypeInt64(), changed);
    EXPECT_EQ(changed == 0, keep == 1);
  }
}
