// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoneVolume.h"
#include "LabelMaps/LabelVolume.h"
#include "Specimen.h"
#include "SurfaceChecks.h"
#include "VolumeFile.h"
#include "VolumeFiles.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace bonedecimate::testing
{
namespace
{
template <typename Number>
std::string With(std::string header, std::size_t position, Number number)
{
  char bytes[sizeof(number)];
  std::memcpy(bytes, &number, sizeof(number));
  return header.replace(position, sizeof(number), bytes, sizeof(number));
}

class ImageFormats : public ::testing::Test
{
protected:
  /// A NIfTI file with this header is rejected with these words.
  void RejectNifti(const std::string& header, const std::string& words)
  {
    WriteBytes(this->Folder.File("a.nii"), header + VoxelBytes(this->Tilted));
    ExpectRejection(this->Folder.File("a.nii"), words);
  }

  std::string Header() const { return NiftiHeader(this->Tilted); }

  TemporaryFolder Folder;
  Scan Tilted = TiltedScan();
};

TEST_F(ImageFormats, NiftiLiesWhereThePatientLay)
{
  for (const Scan& scan : { UprightScan(), TiltedScan(), MirroredScan(), ShearedScan() })
  {
    for (const char* name : { "a.nii", "a.nii.gz" })
    {
      WriteNifti(this->Folder.File(name), scan);
      EXPECT_TRUE(IsVolume(this->Folder.File(name)));
      const BoneSurface bone = ExtractBoneSurface(this->Folder.File(name), SurfaceValue);
      ExpectSpecimen(bone);
      EXPECT_EQ(bone.Note, "");
    }
  }
}

TEST_F(ImageFormats, RejectsNiftiWithWhatItsLibraryPassesOver)
{
  // A qform without rotation instead of the sform.
  const std::string upright =
    With(With(this->Header(), 254, std::int16_t(0)), 252, std::int16_t(1));
  this->RejectNifti(With(upright, 80, 0.0F), "spacing is zero");
  this->RejectNifti(With(upright, 84, -1.0F), "spacing is zero, negative");
  this->RejectNifti(With(upright, 88, std::nanf("")), "not a finite number");
  this->RejectNifti(With(this->Header(), 80, 5.0F), "spacing is not that of its sform");
  this->RejectNifti(With(With(this->Header(), 252, std::int16_t(1)), 80, 5.0F),
    "spacing is not that of its sform"); // both are those of the scanner
  this->RejectNifti(With(this->Header(), 123, char(4)), "unit of length is '4'"); // not defined
  this->RejectNifti(With(this->Header(), 344, 'x'), "");
  this->RejectNifti(
    With(With(this->Header(), 40, std::int16_t(4)), 48, std::int16_t(9)), "4 dimensions");
  this->RejectNifti(With(this->Header(), 70, std::int16_t(128)), ""); // colors
  for (const std::size_t axis : { 0, 1, 2 })
  {
    this->RejectNifti(With(this->Header(), 42 + 2 * axis, std::int16_t(1)), "");
    this->RejectNifti(With(this->Header(), 42 + 2 * axis, std::int16_t(-3)), "");
    this->RejectNifti(With(this->Header(), 42 + 2 * axis, std::int16_t(32767)), "truncated");
  }
}

TEST_F(ImageFormats, SformOfAnotherSpaceMayHaveAnotherSpacingThanTheQform)
{
  const std::string ofScanner = With(this->Header(), 252, std::int16_t(1));
  const std::string header = With(With(ofScanner, 254, std::int16_t(4)), 80, 5.0F);
  WriteBytes(this->Folder.File("a.nii"), header + VoxelBytes(this->Tilted));
  const volume::Volume read = volume::ReadVolume(this->Folder.File("a.nii"));
  ASSERT_EQ(read.Problem, "");
  EXPECT_EQ(read.Geometry.Steps[0][0], -5.0); // the qform does not rotate
  EXPECT_NE(read.Note.find("its sform and qform are up to"), std::string::npos) << read.Note;
}

TEST_F(ImageFormats, AxesOfNiftiAreThoseOfTheFileWhateverTheEnvironmentSays)
{
  setenv("ITK_NIFTI_SFORM_PERMISSIVE", "YES", 1);
  WriteNifti(this->Folder.File("a.nii"), ShearedScan());
  const BoneSurface bone = ExtractBoneSurface(this->Folder.File("a.nii"), SurfaceValue);
  unsetenv("ITK_NIFTI_SFORM_PERMISSIVE");
  ExpectSpecimen(bone);
}

TEST_F(ImageFormats, RejectsTruncatedAndDamagedNifti)
{
  const std::string bytes = this->Header() + VoxelBytes(this->Tilted);
  WriteBytes(this->Folder.File("a.nii"), bytes.substr(0, bytes.size() - 1));
  ExpectRejection(this->Folder.File("a.nii"), "truncated");
  std::string packed = Gzipped(bytes);
  WriteBytes(this->Folder.File("a.nii.gz"), packed.substr(0, packed.size() - 1));
  ExpectRejection(this->Folder.File("a.nii.gz"), "truncated or damaged");
  packed[packed.size() - 6] ^= 0x10; // in the checksum
  WriteBytes(this->Folder.File("a.nii.gz"), packed);
  ExpectRejection(this->Folder.File("a.nii.gz"), "truncated or damaged");
  WriteBytes(this->Folder.File("a.nii.gz"), "not compressed");
  ExpectRejection(this->Folder.File("a.nii.gz"), "");
}

TEST_F(ImageFormats, VoxelsOfNiftiThatAreNoNumbersAreFound)
{
  Scan scan = ScanOf({ { 20, 10, 10 } }, VolumeGeometry());
  scan.Values.assign(scan.Values.size(), 0);
  scan.Values[101] = 0x7fc0;
  scan.Values[201] = 0x7f80;
  std::string header = With(With(NiftiHeader(scan), 70, std::int16_t(16)), 72, std::int16_t(32));
  header = With(header, 42, std::int16_t(10));
  WriteBytes(this->Folder.File("a.nii"), header + VoxelBytes(scan));
  ExpectRejection(this->Folder.File("a.nii"), "2 of its voxels are not finite");
}

TEST_F(ImageFormats, TiffNeedsASpacing)
{
  const Scan scan = UprightScan();
  WriteBytes(this->Folder.File("a.tif"), TiffBytes(scan, 0, scan.Size[2]));
  EXPECT_TRUE(IsVolume(this->Folder.File("a.tif")));
  EXPECT_TRUE(NeedsSpacing(this->Folder.File("a.tif")));
  ExpectRejection(this->Folder.File("a.tif"), "give --spacing X,Y,Z");
  WriteBytes(this->Folder.File("b.tif"), TiffBytes(scan, 0, 1));
  EXPECT_FALSE(IsVolume(this->Folder.File("b.tif")));
  EXPECT_FALSE(NeedsSpacing(this->Folder.File("a.mha")));
}

TEST_F(ImageFormats, TiffFilesAndFoldersHaveTheVoxelsOfTheScan)
{
  Scan scan = UprightScan();
  const VoxelSpacing spacing{ { 0.8, 0.9, 1.3 } };
  const std::string folder = this->Folder.File("slices");
  std::filesystem::create_directory(folder);
  for (std::size_t k = 0; k < scan.Size[2]; ++k)
  {
    WriteBytes(folder + "/bone_8um_" + std::to_string(k + 3) + "_rec.tif", TiffBytes(scan, k, 1));
  }
  WriteBytes(folder + "/scan.log", "not a slice");
  WriteBytes(this->Folder.File("a.tif"), TiffBytes(scan, 0, scan.Size[2]));
  for (const std::string& path : { this->Folder.File("a.tif"), folder })
  {
    const volume::Volume read = volume::ReadVolume(path, spacing);
    ASSERT_EQ(read.Problem, "");
    ASSERT_EQ(read.Image->GetScalarType(), VTK_SHORT);
    ASSERT_EQ(read.Image->GetNumberOfPoints(), static_cast<vtkIdType>(scan.Values.size()));
    EXPECT_EQ(
      std::memcmp(read.Image->GetScalarPointer(), scan.Values.data(), 2 * scan.Values.size()), 0);
    EXPECT_EQ(read.Geometry.Steps[2], (Vector3{ { 0.0, 0.0, 1.3 } }));
  }
}

TEST_F(ImageFormats, RejectsDamagedTiff)
{
  const Scan scan = UprightScan();
  const VoxelSpacing spacing{ { 1.0, 1.0, 1.0 } };
  const std::string bytes = TiffBytes(scan, 0, scan.Size[2]);
  for (const double part : { 0.2, 0.5, 0.9, 0.9999 })
  {
    WriteBytes(this->Folder.File("a.tif"),
      bytes.substr(0, static_cast<std::size_t>(part * static_cast<double>(bytes.size()))));
    const volume::Volume read = volume::ReadVolume(this->Folder.File("a.tif"), spacing);
    EXPECT_FALSE(read.Image);
    EXPECT_NE(read.Problem.find("truncated or damaged"), std::string::npos) << read.Problem;
  }
  const std::size_t second = bytes.size() / scan.Size[2] + 8; // width of the second page
  WriteBytes(this->Folder.File("a.tif"), With(bytes, second + 10, std::uint32_t(49)));
  EXPECT_FALSE(volume::ReadVolume(this->Folder.File("a.tif"), spacing).Image);
}

TEST_F(ImageFormats, RejectsAMissingTiffSlice)
{
  const Scan scan = UprightScan();
  const VoxelSpacing spacing{ { 1.0, 1.0, 1.0 } };
  const std::string folder = this->Folder.File("slices");
  std::filesystem::create_directory(folder);
  for (const int k : { 8, 9, 10, 12 })
  {
    WriteBytes(folder + "/s" + std::to_string(k) + ".tif", TiffBytes(scan, 0, 1));
  }
  EXPECT_NE(volume::ReadVolume(folder, spacing).Problem.find("one before s12.tif is missing"),
    std::string::npos);
  std::filesystem::rename(folder + "/s12.tif", folder + "/s11.tif");
  EXPECT_EQ(volume::ReadVolume(folder, spacing).Problem, "");
  std::filesystem::rename(folder + "/s11.tif", folder + "/sx.tif");
  EXPECT_NE(volume::ReadVolume(folder, spacing).Problem.find("sx.tif"), std::string::npos);
}

//------------------------------------------------------------------------------
class Segmentations : public ::testing::Test
{
protected:
  LabelVolume Read(std::size_t layers, const std::string& segments, const std::string& voxels)
  {
    const std::array<std::size_t, 3> size{ { 2, 2, 2 } };
    WriteBytes(this->Folder.File("a.seg.nrrd"), SegmentationBytes(size, layers, segments, voxels));
    return ReadLabelVolume(this->Folder.File("a.seg.nrrd"));
  }

  static std::vector<int> LabelsOf(const LabelVolume& labels)
  {
    std::vector<int> values;
    vtkDataArray* array = labels.Image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(static_cast<int>(array->GetTuple1(i)));
    }
    return values;
  }

  static double FieldOf(
    const LabelVolume& labels, const char* name, vtkIdType tuple, int component = 0)
  {
    return labels.Image->GetFieldData()->GetArray(name)->GetComponent(tuple, component);
  }

  TemporaryFolder Folder;
  const std::string Femur = "Segment0_ID:=a\nSegment0_Name:=Femur \nSegment0_LabelValue:=1\n"
                            "Segment0_Layer:=0\nSegment0_Color:=1 0.5 0\n";
  const std::string Screw = "Segment1_ID:=b\nSegment1_Name:=Screw\nSegment1_LabelValue:=1\n"
                            "Segment1_Layer:=1\nSegment1_Color:=0 0 1\n";
};

TEST_F(Segmentations, NamesAndColorsComeWithTheLabels)
{
  const std::string voxels("\0\7\7\3\0\0\3\3", 8);
  const LabelVolume labels = this->Read(1,
    "Segment0_ID:=a\nSegment0_Name:=Femur\nSegment0_LabelValue:=7\nSegment0_Color:=1 0.5 0\n"
    "Segment1_ID:=b\nSegment1_LabelValue:=3\n",
    voxels);
  ASSERT_EQ(labels.Problem, "");
  EXPECT_EQ(labels.Note, "");
  EXPECT_EQ(LabelsOf(labels), (std::vector<int>{ 0, 7, 7, 3, 0, 0, 3, 3 }));
  EXPECT_EQ(FieldOf(labels, "LabelValues", 0), 7.0);
  EXPECT_EQ(FieldOf(labels, "LabelValues", 1), 3.0);
  EXPECT_EQ(FieldOf(labels, "LabelColors", 0, 1), 0.5);
  auto* names =
    vtkStringArray::SafeDownCast(labels.Image->GetFieldData()->GetAbstractArray("LabelNames"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->GetValue(0), "Femur");
  EXPECT_EQ(names->GetValue(1), "b");
}

TEST_F(Segmentations, LastOfOverlappingSegmentsCounts)
{
  // Pairs of both layers.
  const std::string voxels("\1\0\1\1\0\1\0\0\1\1\0\0\0\1\1\0", 16);
  const LabelVolume labels = this->Read(2, this->Femur + this->Screw, voxels);
  ASSERT_EQ(labels.Problem, "");
  EXPECT_EQ(LabelsOf(labels), (std::vector<int>{ 1, 2, 2, 0, 2, 0, 2, 1 }));
  EXPECT_EQ(FieldOf(labels, "LabelValues", 1), 2.0);
  EXPECT_NE(labels.Note.find("2 of its voxels are in more than one segment"), std::string::npos)
    << labels.Note;
  EXPECT_NE(labels.Note.find("labels 1 to 2, because"), std::string::npos) << labels.Note;
}

TEST_F(Segmentations, DifferentLabelsOfLayersAreKept)
{
  std::string screw = this->Screw;
  screw.replace(screw.find("LabelValue:=1"), 13, "LabelValue:=9");
  const std::string voxels("\1\0\1\11\0\11\0\0\1\0\0\0\0\11\1\0", 16);
  const LabelVolume labels = this->Read(2, this->Femur + screw, voxels);
  ASSERT_EQ(labels.Problem, "");
  EXPECT_EQ(LabelsOf(labels), (std::vector<int>{ 1, 9, 9, 0, 1, 0, 9, 1 }));
  EXPECT_EQ(labels.Note.find("because"), std::string::npos) << labels.Note;
}

TEST_F(Segmentations, RejectsLayersThatItsHeaderDoesNotDescribe)
{
  const std::string voxels("\1\0\1\2\0\1\0\0\1\1\0\0\0\1\1\0", 16);
  EXPECT_NE(this->Read(2, this->Femur + this->Screw, voxels).Problem.find("1 values of its voxels"),
    std::string::npos);
  EXPECT_NE(this->Read(2, "", voxels).Problem.find("2 values a voxel"), std::string::npos);
  std::string screw = this->Screw;
  screw.replace(screw.find("Layer:=1"), 8, "Layer:=5");
  EXPECT_NE(this->Read(2, this->Femur + screw, voxels).Problem.find("layers"), std::string::npos);
}
}
}
