// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkBoneVoxelCheck: surfaces that keep all voxels, and surfaces that do not.
#include "LabelImages.h"
#include "RejectionWalk.h"

#include "vtkBoneDecimate.h"
#include "vtkBoneVoxelCheck.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
vtkSmartPointer<vtkBoneVoxelCheck> Check(vtkPolyData* surface, vtkImageData* image)
{
  auto check = vtkSmartPointer<vtkBoneVoxelCheck>::New();
  check->SetInputData(0, surface);
  check->SetInputData(1, image);
  check->Update();
  return check;
}

vtkSmartPointer<vtkPolyData> Decimated(vtkPolyData* surface, int keepVoxels)
{
  vtkNew<vtkBoneDecimate> decimate;
  decimate->SetInputData(surface);
  decimate->SetTargetReduction(0.95);
  decimate->SetKeepVoxels(keepVoxels);
  decimate->Update();
  return decimate->GetOutput();
}

std::string ErrorOf(vtkPolyData* surface, vtkImageData* image, int label)
{
  vtkNew<vtkBoneVoxelCheck> check;
  ErrorTexts errors(check);
  check->SetInputData(0, surface);
  check->SetInputData(1, image);
  check->SetLabel(label);
  check->Update();
  return errors.Texts.empty() ? std::string() : errors.Texts.front();
}

int Voxels(const LabelMap& map)
{
  return static_cast<int>(map.Labels.size());
}
}

TEST(BoneVoxelCheck, FindsNoChangeInExtractedSurfaces)
{
  for (const bool isMirrored : { false, true })
  {
    const LabelMap map = ObliqueEllipsoid(isMirrored);
    const vtkSmartPointer<vtkImageData> image = ImageOf(map, VTK_SHORT, { -3, 5, 2 });
    const auto check = Check(Extracted(image), image);
    EXPECT_EQ(check->GetNumberOfComparedVoxels(), Voxels(map));
    EXPECT_EQ(check->GetNumberOfChangedVoxels(), 0);
    vtkTypeInt64 sum = 0;
    for (int i = 0; i < check->GetNumberOfLabels(); ++i)
    {
      sum += check->GetNumberOfVoxels(i);
      EXPECT_EQ(check->GetNumberOfLostVoxels(i) + check->GetNumberOfGainedVoxels(i), 0);
    }
    EXPECT_EQ(sum, Voxels(map));
    EXPECT_EQ(check->GetLabelValue(check->GetNumberOfLabels() - 1), 0);
  }
}

TEST(BoneVoxelCheck, CountsWhatDecimationChangesUnlessVoxelsAreKept)
{
  const LabelMap map = EllipsoidLabels({ 25, 22, 20 });
  const vtkSmartPointer<vtkImageData> image = ImageOf(map);
  const vtkSmartPointer<vtkPolyData> surface = Extracted(image);
  const auto changed = Check(Decimated(surface, 0), image);
  EXPECT_GT(changed->GetNumberOfChangedVoxels(), 0);
  vtkTypeInt64 lost = 0;
  vtkTypeInt64 gained = 0;
  for (int i = 0; i < changed->GetNumberOfLabels(); ++i)
  {
    lost += changed->GetNumberOfLostVoxels(i);
    gained += changed->GetNumberOfGainedVoxels(i);
  }
  EXPECT_EQ(lost, changed->GetNumberOfChangedVoxels());
  EXPECT_LE(gained, lost);
  EXPECT_EQ(Check(Decimated(surface, 1), image)->GetNumberOfChangedVoxels(), 0);
}

TEST(BoneVoxelCheck, TakesASurfaceWithoutArraysForOneLabel)
{
  LabelMap map = EllipsoidLabels({ 15, 13, 12 });
  for (std::int32_t& label : map.Labels)
  {
    label = label != 0 ? 7 : 0;
  }
  const vtkSmartPointer<vtkImageData> image = ImageOf(map);
  vtkNew<vtkPolyData> bare;
  const vtkSmartPointer<vtkPolyData> surface = Extracted(image);
  bare->SetPoints(surface->GetPoints());
  bare->SetPolys(surface->GetPolys());
  const auto check = Check(bare, image);
  EXPECT_EQ(check->GetLabelValue(0), 7) << "the only one";
  EXPECT_EQ(check->GetNumberOfChangedVoxels(), 0);
  EXPECT_EQ(check->GetNumberOfComparedVoxels(), Voxels(map));
  EXPECT_EQ(check->GetNumberOfLabelsLeftOut(), 0);
}

TEST(BoneVoxelCheck, HasToBeToldTheLabelOfASurfaceWithoutArraysIfThereAreSeveral)
{
  LabelMap map = EllipsoidLabels({ 15, 13, 12 });
  for (std::int32_t& label : map.Labels)
  {
    label = label != 0 ? 7 : 0;
  }
  const vtkSmartPointer<vtkPolyData> surface = Extracted(ImageOf(map));
  map.Labels.front() = 3;
  const vtkSmartPointer<vtkImageData> image = ImageOf(map);
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(surface->GetPoints());
  bare->SetPolys(surface->GetPolys());
  EXPECT_NE(ErrorOf(bare, image, 0).find("3, 7"), std::string::npos);
  EXPECT_NE(ErrorOf(bare, image, 9).find("label 9"), std::string::npos);
  EXPECT_EQ(ErrorOf(bare, image, 7), "");
  vtkNew<vtkBoneVoxelCheck> check;
  check->SetInputData(0, bare);
  check->SetInputData(1, image);
  check->SetLabel(7);
  check->Update();
  EXPECT_EQ(check->GetNumberOfChangedVoxels(), 0) << "the voxel of label 3 counts as background";
  ASSERT_EQ(check->GetNumberOfLabelsLeftOut(), 1);
  EXPECT_EQ(check->GetLabelLeftOut(0), 3);
}

TEST(BoneVoxelCheck, TakesNoOtherBackgroundThanThatOfTheSurface)
{
  const LabelMap map = EllipsoidLabels({ 15, 13, 12 });
  const vtkSmartPointer<vtkPolyData> surface = Extracted(ImageOf(map));
  const auto check = Check(surface, ImageOf(map));
  ErrorTexts errors(check);
  check->SetBackgroundLabel(1);
  check->Update();
  ASSERT_FALSE(errors.Texts.empty());
  EXPECT_NE(errors.Texts.front().find("BackgroundLabel is 1"), std::string::npos);
  EXPECT_EQ(check->GetNumberOfComparedVoxels(), 0);
}

TEST(BoneVoxelCheck, TellsTheFirstChangedVoxel)
{
  LabelMap map = EllipsoidLabels({ 15, 13, 12 });
  const vtkSmartPointer<vtkPolyData> surface = Extracted(ImageOf(map));
  map.Labels[static_cast<std::size_t>(4 + 15 * (5 + 13 * 6))] += 1;
  const auto check = Check(surface, ImageOf(map));
  int voxel[3] = {};
  check->GetFirstChangedVoxel(voxel);
  EXPECT_EQ(check->GetNumberOfChangedVoxels(), 1);
  EXPECT_EQ(voxel[0], 4);
  EXPECT_EQ(voxel[1], 5);
  EXPECT_EQ(voxel[2], 6);
}

TEST(BoneVoxelCheck, RejectsAPieceOfASurface)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(EllipsoidLabels({ 15, 13, 12 }));
  const auto check = Check(Extracted(image), image);
  EXPECT_GT(check->GetNumberOfComparedVoxels(), 0);
  ErrorTexts errors(check);
  check->UpdatePiece(0, 2, 0);
  EXPECT_EQ(check->GetNumberOfComparedVoxels(), 0);
  EXPECT_EQ(errors.Count("one process alone"), 1);
}

TEST(BoneVoxelCheck, RejectsALabelWhereTheSurfaceSaysWhatItEncloses)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(EllipsoidLabels({ 15, 13, 12 }));
  const vtkSmartPointer<vtkPolyData> surface = Extracted(image);
  EXPECT_NE(ErrorOf(surface, image, 2).find("BoundaryLabels"), std::string::npos);
  EXPECT_EQ(ErrorOf(surface, image, 0), "");
}

TEST(BoneVoxelCheck, RejectsPointsAndTrianglesThatCannotBeVoxelized)
{
  LabelMap map = EllipsoidLabels({ 15, 13, 12 });
  for (std::int32_t& label : map.Labels)
  {
    label = label != 0 ? 7 : 0;
  }
  const vtkSmartPointer<vtkImageData> image = ImageOf(map);
  const vtkSmartPointer<vtkPolyData> good = Extracted(image);
  const auto errorOf = [&](double coordinate, vtkIdType corner)
  {
    vtkNew<vtkPolyData> surface;
    vtkNew<vtkPoints> points;
    points->DeepCopy(good->GetPoints());
    vtkNew<vtkCellArray> triangles;
    triangles->DeepCopy(good->GetPolys());
    const double moved[3] = { coordinate, 1.0, 1.0 };
    points->InsertNextPoint(moved);
    const vtkIdType corners[3] = { 0, 1, corner < 0 ? points->GetNumberOfPoints() - 1 : corner };
    triangles->InsertNextCell(3, corners);
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    return ErrorOf(surface, image, 0);
  };
  EXPECT_EQ(errorOf(1.0, -1), "");
  EXPECT_NE(
    errorOf(1.0, 1000000).find("1 triangle has point indices out of range"), std::string::npos);
  EXPECT_NE(
    errorOf(std::nan(""), -1).find("1 point has NaN or infinite coordinates"), std::string::npos);
  EXPECT_NE(errorOf(1e31, -1).find("beyond 1e30"), std::string::npos);
  EXPECT_NE(errorOf(1e6, -1).find("farther than 65536 voxels"), std::string::npos);
}

TEST(BoneVoxelCheck, HasNoCountsOfAPartAfterAnAbort)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(EllipsoidLabels({ 60, 50, 40 }));
  const vtkSmartPointer<vtkPolyData> surface = Extracted(image);
  vtkNew<vtkBoneVoxelCheck> check;
  check->SetInputData(0, surface);
  check->SetInputData(1, image);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1); });
  const unsigned long observer = check->AddObserver(vtkCommand::ProgressEvent, abort);
  check->Update();
  EXPECT_TRUE(check->GetWasStopped());
  EXPECT_EQ(check->GetNumberOfComparedVoxels(), 0);
  EXPECT_EQ(check->GetNumberOfLabels(), 0);
  check->RemoveObserver(observer);
  check->SetAbortExecute(0);
  check->Modified();
  check->Update();
  EXPECT_FALSE(check->GetWasStopped());
  EXPECT_EQ(check->GetNumberOfComparedVoxels(), 60 * 50 * 40);
}
