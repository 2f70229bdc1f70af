// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoneVolume.h"
#include "Specimen.h"
#include "SurfaceChecks.h"
#include "VolumeFiles.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace bonedecimate::testing
{
namespace
{
/// Points, triangles and nothing else.
void ExpectBare(const BoneSurface& bone)
{
  ASSERT_EQ(bone.Problem, "");
  EXPECT_EQ(bone.Note, "");
  EXPECT_EQ(bone.Surface->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(bone.Surface->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(bone.Surface->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(bone.Surface->GetNumberOfCells(), bone.Surface->GetNumberOfPolys());
}

TEST(Privacy, FieldDataOfAVtkImageStayBehind)
{
  const TemporaryFolder folder;
  WriteVti(folder.File("a.vti"), UprightScan()); // has the patient's name in its field data
  ASSERT_NE(ReadBytes(folder.File("a.vti")).find("PatientName"), std::string::npos);
  ExpectBare(ExtractBoneSurface(folder.File("a.vti"), SurfaceValue));
}

TEST(Privacy, KeysOfANrrdHeaderStayBehind)
{
  const TemporaryFolder folder;
  const Scan scan = UprightScan();
  WriteBytes(folder.File("a.nrrd"),
    NrrdHeader(scan, "left-posterior-superior", "raw") + "DICOM_0010_0010:=Secret^Patient\n\n" +
      VoxelBytes(scan));
  ExpectBare(ExtractBoneSurface(folder.File("a.nrrd"), SurfaceValue));
}

TEST(Privacy, CommentOfAMetaImageStaysBehind)
{
  const TemporaryFolder folder;
  const Scan scan = UprightScan();
  WriteBytes(folder.File("a.mha"),
    MetaHeader(scan, "Comment = Secret^Patient\n") + "ElementDataFile = LOCAL\n" +
      VoxelBytes(scan));
  ExpectBare(ExtractBoneSurface(folder.File("a.mha"), SurfaceValue));
}
}
}
