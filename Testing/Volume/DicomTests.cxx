// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoneVolume.h"
#include "DicomFiles.h"
#include "Specimen.h"
#include "SurfaceChecks.h"
#include "VolumeFiles.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace bonedecimate::testing
{
namespace
{
class Dicom : public ::testing::Test
{
protected:
  BoneSurface Bone() const { return ExtractBoneSurface(this->Series, SurfaceValue); }

  TemporaryFolder Folder;
  std::string Series = Folder.File("series");
  Scan Tilted = TiltedScan();
};

TEST_F(Dicom, ShuffledFilesOfATiltedPlaneLieWhereThePatientLay)
{
  WriteDicom(this->Series, this->Tilted);
  EXPECT_TRUE(IsVolume(this->Series));
  const BoneSurface bone = this->Bone();
  ExpectSpecimen(bone);
  WriteMeta(this->Folder.File("a.mha"), this->Tilted);
  ExpectEqual(
    ExtractBoneSurface(this->Folder.File("a.mha"), SurfaceValue).Surface, bone.Surface, 1e-3);
}

TEST_F(Dicom, SlicesThatRunAgainstTheNormalAreTurned)
{
  WriteDicom(this->Series, MirroredScan());
  ExpectSpecimen(this->Bone());
}

TEST_F(Dicom, TiltedGantryIsFollowed)
{
  WriteDicom(this->Series, ShearedScan());
  ExpectSpecimen(this->Bone());
}

TEST_F(Dicom, SlopeAndInterceptAreApplied)
{
  SeriesOptions options;
  options.Slope = 0.5;
  options.Intercept = -1024.0;
  WriteDicom(this->Series, this->Tilted, options);
  ExpectSpecimen(this->Bone());
}

TEST_F(Dicom, CompressedSlicesAreTheSame)
{
  WriteDicom(this->Series, this->Tilted);
  const BoneSurface plain = this->Bone();
  for (const auto syntax :
    { gdcm::TransferSyntax::JPEGLosslessProcess14_1, gdcm::TransferSyntax::JPEGLSLossless,
      gdcm::TransferSyntax::JPEG2000Lossless, gdcm::TransferSyntax::RLELossless })
  {
    SeriesOptions options;
    options.Syntax = syntax;
    const std::string packed = this->Folder.File("packed" + std::to_string(syntax));
    WriteDicom(packed, this->Tilted, options);
    const BoneSurface bone = ExtractBoneSurface(packed, SurfaceValue);
    ASSERT_EQ(bone.Problem, "") << gdcm::TransferSyntax::GetTSString(syntax);
    ExpectEqual(plain.Surface, bone.Surface, 0.0);
  }
}

TEST_F(Dicom, LargestSeriesIsTakenAndTheOthersAreNamed)
{
  WriteDicom(this->Series, this->Tilted);
  SeriesOptions other;
  other.Prefix = "other";
  other.Series = "7";
  other.Count = 9;
  WriteDicom(this->Series, UprightScan(), other);
  const BoneSurface bone = this->Bone();
  ExpectSpecimen(bone);
  EXPECT_EQ(bone.Note,
    "Of 2 series the one with 40 slices was taken; others, for --series: 2: 9 slices from other100 "
    "on.");
}

TEST_F(Dicom, CtIsTakenBeforeALargerSeriesOfAnotherKind)
{
  SeriesOptions few;
  few.First = 2;
  few.Count = 36;
  WriteDicom(this->Series, this->Tilted, few);
  SeriesOptions other;
  other.Prefix = "other";
  other.Series = "7";
  other.Modality = "PT";
  WriteDicom(this->Series, UprightScan(), other);
  const BoneSurface bone = this->Bone();
  ExpectSpecimen(bone);
  EXPECT_EQ(bone.Note,
    "Of 2 series the one with 36 slices was taken; others, for --series: 2: 40 slices from "
    "other100 on.");
}

TEST_F(Dicom, LocalizerOfTheSameSeriesIsLeftAside)
{
  WriteDicom(this->Series, this->Tilted);
  SeriesOptions localizer;
  localizer.Prefix = "localizer";
  localizer.First = 3;
  localizer.Count = 1;
  WriteDicom(this->Series, UprightScan(), localizer);
  ExpectSpecimen(this->Bone());
}

TEST_F(Dicom, CopiesOfFilesCountOnce)
{
  WriteDicom(this->Series, this->Tilted);
  SeriesOptions copies;
  copies.Prefix = "copy";
  copies.Count = 5;
  WriteDicom(this->Series, this->Tilted, copies);
  const BoneSurface bone = this->Bone();
  ExpectSpecimen(bone);
  EXPECT_EQ(bone.Note, "5 files are copies of others and were left aside.");
}

TEST_F(Dicom, OtherFilesInTheFolderDoNotMatter)
{
  WriteDicom(this->Series, this->Tilted);
  WriteBytes(this->Series + "/notes.txt", "not DICOM");
  WriteBytes(this->Series + "/empty", "");
  const BoneSurface bone = this->Bone();
  ExpectSpecimen(bone);
  EXPECT_EQ(bone.Note, "");
}

// It may be the last slice, and no gap would show that it is missing.
TEST_F(Dicom, ADamagedFileIsNamed)
{
  WriteDicom(this->Series, this->Tilted);
  for (const char* const rest : { "DICM", "DICM and no more" })
  {
    WriteBytes(this->Series + "/damaged", std::string(128, '\0') + rest);
    ExpectRejection(this->Series, "its file damaged is damaged or truncated");
  }
}

TEST_F(Dicom, NothingOfThePatientComesAlong)
{
  WriteDicom(this->Series, this->Tilted);
  const BoneSurface bone = this->Bone();
  ASSERT_EQ(bone.Problem, "");
  EXPECT_EQ(bone.Note, "");
  EXPECT_EQ(bone.Surface->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(bone.Surface->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(bone.Surface->GetCellData()->GetNumberOfArrays(), 0);
}

TEST_F(Dicom, RejectsAMissingSlice)
{
  SeriesOptions lower;
  lower.Count = 15;
  WriteDicom(this->Series, this->Tilted, lower);
  SeriesOptions upper;
  upper.First = 16;
  WriteDicom(this->Series, this->Tilted, upper);
  ExpectRejection(this->Series, "not evenly spaced");
}

TEST_F(Dicom, RejectsASingleSlice)
{
  SeriesOptions one;
  one.Count = 1;
  WriteDicom(this->Series, this->Tilted, one);
  ExpectRejection(this->Series, "one slice");
}

TEST_F(Dicom, RejectsFilesOfSeveralFrames)
{
  SeriesOptions frames;
  frames.Frames = 12;
  WriteDicom(this->Series, this->Tilted, frames);
  ExpectRejection(this->Series, "several frames");
}

TEST_F(Dicom, RejectsColors)
{
  SeriesOptions colors;
  colors.Colors = gdcm::PhotometricInterpretation::RGB;
  WriteDicom(this->Series, this->Tilted, colors);
  ExpectRejection(this->Series, "more than one value");
}

TEST_F(Dicom, RejectsTruncatedSlices)
{
  for (const auto syntax : { gdcm::TransferSyntax::ExplicitVRLittleEndian,
         gdcm::TransferSyntax::JPEGLosslessProcess14_1, gdcm::TransferSyntax::JPEGLSLossless,
         gdcm::TransferSyntax::JPEG2000Lossless, gdcm::TransferSyntax::RLELossless })
  {
    SCOPED_TRACE(gdcm::TransferSyntax::GetTSString(syntax));
    SeriesOptions options;
    options.Syntax = syntax;
    WriteDicom(this->Series, this->Tilted, options);
    const std::string middle = this->Series + "/slice" + std::to_string(100 + 20 * 37 % 41);
    std::filesystem::resize_file(middle, std::filesystem::file_size(middle) - 200);
    ExpectRejection(this->Series, "");
  }
}

TEST_F(Dicom, RejectsDamagedFilesWithoutNamingThePatient)
{
  WriteDicom(this->Series, this->Tilted);
  for (const auto& entry : std::filesystem::directory_iterator(this->Series))
  {
    std::string bytes = ReadBytes(entry.path().string());
    bytes.resize(bytes.size() / 3);
    WriteBytes(entry.path().string(), bytes);
  }
  ExpectRejection(this->Series, "");
  EXPECT_EQ(this->Bone().Problem.find("Secret"), std::string::npos);
}

TEST_F(Dicom, RejectsOneSliceByItsFile)
{
  WriteDicom(this->Series, this->Tilted);
  std::filesystem::rename(this->Series + "/slice100", this->Series + "/a.dcm");
  ExpectRejection(this->Series + "/a.dcm", "give the folder of its series");
}

TEST_F(Dicom, RejectsAFileThatIsNone)
{
  WriteBytes(this->Folder.File("a.dcm"), "DICM");
  ExpectRejection(this->Folder.File("a.dcm"), "not a DICOM file");
}

// Debian's GDCM aborts on such a file.
TEST_F(Dicom, RejectsAFileThatEndsAfterItsMark)
{
  std::filesystem::create_directory(this->Series);
  WriteBytes(this->Series + "/a", std::string(128, '\0') + "DICM");
  EXPECT_TRUE(IsVolume(this->Series));
  ExpectRejection(this->Series, "damaged");
}
}
}
