// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Specimen.h"
#include "SurfaceChecks.h"
#include "VolumeFile.h"
#include "VolumeFiles.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace bonedecimate::testing
{
namespace
{
/// Small files of all formats.
std::map<std::string, std::string> WholeFiles()
{
  Scan scan = ScanOf({ { 6, 5, 4 } }, VolumeGeometry());
  const std::string voxels = VoxelBytes(scan);
  const std::string packed = Deflated(voxels);
  return { { "a.mha", MetaHeader(scan) + "ElementDataFile = LOCAL\n" + voxels },
    { "b.mha",
      MetaHeader(scan,
        "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\n") +
        "ElementDataFile = LOCAL\n" + packed },
    { "a.nrrd", NrrdHeader(scan, "right-anterior-superior", "raw") + "\n" + voxels },
    { "b.nrrd", NrrdHeader(scan, "left-posterior-superior", "gzip") + "\n" + Gzipped(voxels) },
    { "c.nrrd",
      SegmentationBytes({ { 3, 2, 2 } }, 2,
        "Segment0_ID:=a\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
        "Segment1_ID:=b\nSegment1_LabelValue:=1\nSegment1_Layer:=1\n",
        std::string(24, '\1')) },
    { "a.nii", NiftiHeader(scan) + voxels }, { "a.nii.gz", Gzipped(NiftiHeader(scan) + voxels) },
    { "a.tif", TiffBytes(scan, 0, 4) } };
}

TEST(DamagedFiles, AreReadOrRejectedWithASentenceWhateverTheyHold)
{
  const TemporaryFolder folder;
  const VoxelSpacing spacing{ { 1.0, 1.0, 1.0 } };
  const std::string pieces[] = { "-1", "0", "nan", "99999999999", "\n", "(", ":=", "\xff", "7" };
  std::mt19937 random(7); // its numbers are the same on every system
  for (const auto& [name, whole] : WholeFiles())
  {
    WriteBytes(folder.File(name), whole);
    ASSERT_TRUE(volume::ReadVolume(folder.File(name), spacing).Image) << name;
    for (int round = 0; round < 16; ++round)
    {
      std::string bytes = whole;
      for (int change = 0; change < 3; ++change)
      {
        const std::string& piece = pieces[random() % 9];
        bytes.replace(random() % bytes.size(), piece.size(), piece);
      }
      bytes.resize(round % 4 == 0 ? random() % bytes.size() : bytes.size());
      WriteBytes(folder.File(name), bytes);
      ::testing::internal::CaptureStderr();
      const volume::Volume read = volume::ReadVolume(folder.File(name), spacing);
      EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << name << ", round " << round;
      EXPECT_EQ(read.Image == nullptr, !read.Problem.empty()) << name << ", round " << round;
    }
  }
}
}
}
