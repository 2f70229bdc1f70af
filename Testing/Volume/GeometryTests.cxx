// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoneVolume.h"
#include "LabelMaps/LabelVolume.h"
#include "Specimen.h"
#include "SurfaceChecks.h"
#include "VolumeFiles.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace bonedecimate::testing
{
namespace
{
struct Grid
{
  const char* Name;
  Scan (*Scanned)();
};

std::ostream& operator<<(std::ostream& stream, const Grid& grid)
{
  return stream << grid.Name;
}

class WhereThePatientLay : public ::testing::TestWithParam<Grid>
{
protected:
  TemporaryFolder Folder;
};

INSTANTIATE_TEST_SUITE_P(Grids, WhereThePatientLay,
  ::testing::Values(Grid{ "Upright", UprightScan }, Grid{ "Tilted", TiltedScan },
    Grid{ "Mirrored", MirroredScan }, Grid{ "Sheared", ShearedScan }),
  [](const auto& param) { return std::string(param.param.Name); });

// A sheared direction matrix is legal in both formats.
TEST_P(WhereThePatientLay, MetaImage)
{
  WriteMeta(this->Folder.File("a.mha"), GetParam().Scanned());
  const BoneSurface bone = ExtractBoneSurface(this->Folder.File("a.mha"), SurfaceValue);
  ExpectSpecimen(bone);
  EXPECT_NEAR(bone.VoxelSize, 0.8, 1e-9);
}

TEST_P(WhereThePatientLay, NrrdInEverySpace)
{
  const Scan scan = GetParam().Scanned();
  for (const std::string space :
    { "left-posterior-superior", "right-anterior-superior", "left-anterior-superior" })
  {
    WriteBytes(
      this->Folder.File("a.nrrd"), NrrdHeader(scan, space, "raw") + "\n" + VoxelBytes(scan));
    ExpectSpecimen(ExtractBoneSurface(this->Folder.File("a.nrrd"), SurfaceValue));
  }
}

TEST_P(WhereThePatientLay, VtkImage)
{
  WriteVti(this->Folder.File("a.vti"), GetParam().Scanned());
  ExpectSpecimen(ExtractBoneSurface(this->Folder.File("a.vti"), SurfaceValue));
}

TEST_P(WhereThePatientLay, TheSameFromEveryFormat)
{
  const Scan scan = GetParam().Scanned();
  WriteMeta(this->Folder.File("a.mha"), scan);
  WriteNrrd(this->Folder.File("a.nrrd"), scan);
  WriteVti(this->Folder.File("a.vti"), scan);
  const BoneSurface meta = ExtractBoneSurface(this->Folder.File("a.mha"), SurfaceValue);
  const BoneSurface nrrd = ExtractBoneSurface(this->Folder.File("a.nrrd"), SurfaceValue);
  const BoneSurface vti = ExtractBoneSurface(this->Folder.File("a.vti"), SurfaceValue);
  // Single precision at 400 mm resolves 0.00003 mm.
  ExpectEqual(meta.Surface, nrrd.Surface, 1e-4);
  ExpectEqual(meta.Surface, vti.Surface, 1e-4);
}

TEST_P(WhereThePatientLay, LabelsOfEveryFormat)
{
  const Scan scan = GetParam().Scanned();
  WriteMeta(this->Folder.File("a.mha"), scan);
  WriteNrrd(this->Folder.File("a.nrrd"), scan);
  WriteVti(this->Folder.File("a.vti"), scan);
  for (const char* name : { "a.mha", "a.nrrd", "a.vti" })
  {
    const LabelVolume labels = ReadLabelVolume(this->Folder.File(name));
    ASSERT_TRUE(labels.Image) << labels.Problem;
    const double index[3] = { 3.0, 5.0, 2.0 };
    double position[3];
    labels.Image->TransformContinuousIndexToPhysicalPoint(index, position);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto& steps = scan.Geometry.Steps;
      const double expected =
        scan.Geometry.Origin[i] + 3.0 * steps[0][i] + 5.0 * steps[1][i] + 2.0 * steps[2][i];
      EXPECT_NEAR(position[i], expected, 1e-9);
    }
  }
}

class Storage : public ::testing::Test
{
protected:
  void SetUp() override
  {
    WriteMeta(this->Folder.File("plain.mha"), this->Tilted);
    this->Plain = ExtractBoneSurface(this->Folder.File("plain.mha"), SurfaceValue);
    ASSERT_EQ(this->Plain.Problem, "");
  }

  /// Reads that file and expects exactly the surface of the plain one.
  void ExpectTheSame(const std::string& file)
  {
    const BoneSurface bone = ExtractBoneSurface(this->Folder.File(file), SurfaceValue);
    ASSERT_EQ(bone.Problem, "");
    ExpectEqual(this->Plain.Surface, bone.Surface, 1e-4);
  }

  TemporaryFolder Folder;
  Scan Tilted = TiltedScan();
  BoneSurface Plain;
};

TEST_F(Storage, CompressedMetaImageIsTheSame)
{
  WriteCompressedMeta(this->Folder.File("a.mha"), this->Tilted, Deflated(VoxelBytes(this->Tilted)));
  this->ExpectTheSame("a.mha");
}

TEST_F(Storage, BigEndianMetaImageWithAFileOfItsOwnIsTheSame)
{
  WriteBytes(this->Folder.File("a.mhd"),
    MetaHeader(this->Tilted, "ElementByteOrderMSB = True\n") + "ElementDataFile = voxels.raw\n");
  WriteBytes(this->Folder.File("voxels.raw"), VoxelBytes(this->Tilted, true));
  this->ExpectTheSame("a.mhd");
}

TEST_F(Storage, VoxelsAtTheEndOfAForeignFileAreFound)
{
  WriteBytes(this->Folder.File("a.mhd"),
    MetaHeader(this->Tilted, "HeaderSize = -1\n") + "ElementDataFile = voxels.raw\n");
  WriteBytes(this->Folder.File("voxels.raw"), "some header" + VoxelBytes(this->Tilted));
  this->ExpectTheSame("a.mhd");
}

TEST_F(Storage, HeaderWithLineEndsOfWindowsIsTheSame)
{
  std::string header = MetaHeader(this->Tilted) + "ElementDataFile = voxels.raw\n";
  for (std::size_t position = header.find('\n'); position != std::string::npos;
       position = header.find('\n', position + 2))
  {
    header.replace(position, 1, "\r\n");
  }
  WriteBytes(this->Folder.File("a.MHD"), header);
  WriteBytes(this->Folder.File("voxels.raw"), VoxelBytes(this->Tilted));
  this->ExpectTheSame("a.MHD");
}

TEST_F(Storage, GzippedNrrdIsTheSame)
{
  WriteBytes(this->Folder.File("a.nrrd"),
    NrrdHeader(this->Tilted, "right-anterior-superior", "gzip") + "\n" +
      Gzipped(VoxelBytes(this->Tilted)));
  this->ExpectTheSame("a.nrrd");
}

TEST_F(Storage, NrrdWithAFileOfItsOwnIsTheSame)
{
  WriteBytes(this->Folder.File("a.nhdr"),
    NrrdHeader(this->Tilted, "left-posterior-superior", "raw") +
      "byte skip: 5\ndata file: voxels.raw\n");
  WriteBytes(this->Folder.File("voxels.raw"), "12345" + VoxelBytes(this->Tilted));
  this->ExpectTheSame("a.nhdr");
}

TEST(IsVolume, KnowsFilesByTheirExtension)
{
  EXPECT_TRUE(IsVolume("a.vti"));
  EXPECT_TRUE(IsVolume("a.MHA"));
  EXPECT_TRUE(IsVolume("a.mhd"));
  EXPECT_TRUE(IsVolume("a.nrrd"));
  EXPECT_TRUE(IsVolume("a.nhdr"));
  EXPECT_TRUE(IsVolume("a.nii"));
  EXPECT_TRUE(IsVolume("a.NII.gz"));
  EXPECT_TRUE(IsVolume("a.tif"));
  EXPECT_FALSE(IsVolume("a.gz"));
  EXPECT_FALSE(IsVolume("a.stl"));
  EXPECT_FALSE(IsVolume("vti"));
}

TEST(IsVolume, FolderOfMeshesIsNone)
{
  const TemporaryFolder folder;
  WriteBytes(folder.File("a.stl"), "solid");
  EXPECT_FALSE(IsVolume(folder.File("")));
}
}
}
