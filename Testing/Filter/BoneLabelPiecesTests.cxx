// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkBoneLabelPieces: an image without small islands and cavities.
#include "LabelImages.h"
#include "RejectionWalk.h"

#include "vtkBoneLabelPieces.h"

#include <gtest/gtest.h>

#include <limits>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Label 2 but for a voxel that is 0 and one that is 3; a voxel of 3 outside.
vtkSmartPointer<vtkImageData> Image()
{
  return ImageOf(
    MakeLabelMap({ 12, 9, 8 },
      [](const std::array<Index, 3>& v)
      {
        const bool isIn = v[0] > 0 && v[0] < 9 && v[1] > 0 && v[1] < 8 && v[2] > 0 && v[2] < 7;
        const bool isRow = v[1] == 4 && v[2] == 4;
        return isRow && v[0] == 3 ? 0 : isRow && (v[0] == 6 || v[0] > 9) ? 3 : isIn ? 2 : 0;
      }),
    VTK_LONG_LONG, { -3, 5, 2 });
}

int At(vtkImageData* image, int x)
{
  return static_cast<int>(image->GetScalarComponentAsDouble(x - 3, 4 + 5, 4 + 2, 0));
}
}

TEST(BoneLabelPieces, ChangesNothingByDefault)
{
  vtkNew<vtkBoneLabelPieces> pieces;
  pieces->SetInputData(Image());
  pieces->Update();
  EXPECT_EQ(At(pieces->GetOutput(), 3), 0);
  EXPECT_EQ(At(pieces->GetOutput(), 6), 3);
  EXPECT_EQ(pieces->GetNumberOfIslands(3), 0);
  EXPECT_EQ(pieces->GetNumberOfCavities(2), 0);
}

TEST(BoneLabelPieces, RemovesIslandsAndFillsCavitiesOfTheLabelsThatWereAdded)
{
  const vtkSmartPointer<vtkImageData> image = Image();
  vtkNew<vtkBoneLabelPieces> pieces;
  pieces->SetInputData(image);
  pieces->SetIslandVolume(1.5);
  pieces->SetCavityVolume(1.0);
  pieces->Update();
  EXPECT_EQ(At(pieces->GetOutput(), 3), 2);
  EXPECT_EQ(At(pieces->GetOutput(), 6), 2);
  EXPECT_EQ(At(pieces->GetOutput(), 10), 3);
  EXPECT_EQ(pieces->GetNumberOfIslands(3), 1);
  EXPECT_EQ(pieces->GetNumberOfIslandVoxels(3), 1);
  EXPECT_EQ(pieces->GetNumberOfCavities(2), 1);
  EXPECT_EQ(pieces->GetNumberOfCavityVoxels(2), 1);
  EXPECT_FALSE(pieces->IsLargestPieceTooSmall(3));
  EXPECT_EQ(At(image, 3), 0) << "the input does not change";
  EXPECT_EQ(pieces->GetOutput()->GetScalarType(), VTK_LONG_LONG);
  pieces->AddLabel(3);
  pieces->Update();
  EXPECT_EQ(At(pieces->GetOutput(), 3), 0);
  EXPECT_EQ(At(pieces->GetOutput(), 6), 2);
}

TEST(BoneLabelPieces, RejectsLimitsThatAreNoLengths)
{
  vtkNew<vtkBoneLabelPieces> pieces;
  const ErrorTexts errors(pieces);
  pieces->SetInputData(Image());
  pieces->SetCavityVolume(std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(pieces->GetRejectedValue("CavityVolume"), "");
  pieces->Update();
  EXPECT_EQ(pieces->GetOutput()->GetNumberOfPoints(), 0);
  pieces->SetCavityVolume(1.0);
  EXPECT_EQ(pieces->GetRejectedValue("CavityVolume"), "");
  pieces->Update();
  EXPECT_EQ(At(pieces->GetOutput(), 3), 2);
}

TEST(BoneLabelPieces, RejectsAnImageThatIsAPiece)
{
  const auto producer = PieceOf(Image());
  vtkNew<vtkBoneLabelPieces> pieces;
  pieces->SetInputConnection(producer->GetOutputPort());
  pieces->SetCavityVolume(1.0);
  const ErrorTexts errors(pieces);
  pieces->Update();
  EXPECT_EQ(pieces->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(errors.Count("one of several pieces"), 1);
}

TEST(BoneLabelPieces, KeepsWhatWasActiveBeside)
{
  const vtkSmartPointer<vtkImageData> image = Image();
  vtkNew<vtkDoubleArray> scan;
  scan->SetName("CT");
  scan->SetNumberOfValues(image->GetNumberOfPoints());
  scan->Fill(1000.0);
  image->GetPointData()->AddArray(scan);
  image->GetPointData()->SetActiveScalars("CT");
  vtkNew<vtkBoneLabelPieces> pieces;
  pieces->SetInputData(image);
  pieces->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Labels");
  pieces->SetIslandVolume(1.5);
  pieces->Update();
  vtkPointData* data = pieces->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetArray("CT"), scan.Get());
  EXPECT_EQ(data->GetScalars(), data->GetArray("Labels"));
  EXPECT_EQ(At(pieces->GetOutput(), 6), 2);
}
