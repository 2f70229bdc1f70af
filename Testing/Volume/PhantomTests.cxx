// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoneVolume.h"
#include "LabelMaps/LabelVolume.h"
#include "Specimen.h"
#include "SurfaceChecks.h"
#include "VolumeFiles.h"

#include <gtest/gtest.h>

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <sys/wait.h>
#include <zlib.h>

namespace bonedecimate::testing
{
namespace
{
int RunPhantom(const std::string& arguments)
{
  const std::string command =
    std::string("\"") + PHANTOM_PROGRAM + "\" " + arguments + " 2>/dev/null";
  return WEXITSTATUS(std::system(command.c_str()));
}

unsigned long Checksum(const std::string& path)
{
  const std::string bytes = ReadBytes(path);
  return crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
}

TEST(Phantom, SmallOneIsAFractureOfSomeThousandTriangles)
{
  const TemporaryFolder folder;
  ASSERT_EQ(RunPhantom(folder.File("a.mha") + " --size small"), 0);
  const BoneSurface bone = ExtractBoneSurface(folder.File("a.mha"), SurfaceValue);
  ASSERT_EQ(bone.Problem, "");
  EXPECT_GT(bone.Surface->GetNumberOfPolys(), 20000);
  EXPECT_LT(bone.Surface->GetNumberOfPolys(), 40000);
  // Two parts of the shaft, the butterfly fragment, three chips, the fibula's two walls, and few
  // crumbs.
  EXPECT_GE(CountComponents(bone.Surface), 8);
  EXPECT_LE(CountComponents(bone.Surface), 30);
}

TEST(Phantom, NormalOneIsABoneOfSomeHundredThousandTriangles)
{
  const TemporaryFolder folder;
  ASSERT_EQ(RunPhantom(folder.File("a.mha")), 0);
  const BoneSurface bone = ExtractBoneSurface(folder.File("a.mha"), SurfaceValue);
  ASSERT_EQ(bone.Problem, "");
  EXPECT_GT(bone.Surface->GetNumberOfPolys(), 200000);
  EXPECT_LT(bone.Surface->GetNumberOfPolys(), 400000);
  EXPECT_GE(CountComponents(bone.Surface), 8);
  EXPECT_LE(CountComponents(bone.Surface), 100);
  EXPECT_GT(EnclosedVolume(bone.Surface), 0.0);
  // Pictures and their baselines are made of it: it must be the same on every system.
  EXPECT_EQ(Checksum(folder.File("a.mha")), 0x1fe63e9bUL);
}

TEST(Phantom, IsTheSameEveryTime)
{
  const TemporaryFolder folder;
  ASSERT_EQ(RunPhantom(folder.File("a.mha") + " --size small"), 0);
  ASSERT_EQ(RunPhantom(folder.File("b.mha") + " --size small"), 0);
  EXPECT_EQ(ReadBytes(folder.File("a.mha")), ReadBytes(folder.File("b.mha")));
  EXPECT_EQ(Checksum(folder.File("a.mha")), 0x5cd9bc84UL);
}

TEST(Phantom, LabelMapHasThreeBonesOfWhichTwoTouch)
{
  const TemporaryFolder folder;
  ASSERT_EQ(RunPhantom(folder.File("a.mha") + " --size small --labels"), 0);
  const LabelVolume labels = ReadLabelVolume(folder.File("a.mha"));
  ASSERT_EQ(labels.Problem, "");
  vtkDataArray* voxels = labels.Image->GetPointData()->GetScalars();
  const vtkIdType layer = 84 * 84;
  std::map<double, int> counts;
  int touching = 0;
  for (vtkIdType i = 0; i < voxels->GetNumberOfTuples(); ++i)
  {
    const double label = voxels->GetComponent(i, 0);
    ++counts[label];
    touching += i >= layer && label == 1.0 && voxels->GetComponent(i - layer, 0) == 2.0 ? 1 : 0;
  }
  ASSERT_EQ(counts.size(), 4U);
  EXPECT_GT(counts[1], 1000);
  EXPECT_GT(counts[2], 1000);
  EXPECT_GT(counts[3], 1000);
  EXPECT_GT(touching, 100);
}

TEST(Phantom, TrabeculaeAreANetworkOfTheSameBytesEverywhere)
{
  const TemporaryFolder folder;
  ASSERT_EQ(RunPhantom(folder.File("a.mha") + " --trabeculae 128"), 0);
  EXPECT_EQ(Checksum(folder.File("a.mha")), 0xc1cc0be4UL);
  const BoneSurface bone = ExtractBoneSurface(folder.File("a.mha"), 127.5);
  ASSERT_EQ(bone.Problem, "");
  const vtkIdType voxels = 128 * 128 * 128;
  EXPECT_GT(bone.Surface->GetNumberOfPolys(), voxels / 50);
  EXPECT_LT(bone.Surface->GetNumberOfPolys(), voxels / 20);
  EXPECT_LE(CountComponents(bone.Surface), 10);
}

TEST(Phantom, SaysHowItIsUsed)
{
  const TemporaryFolder folder;
  EXPECT_EQ(RunPhantom(""), 1);
  EXPECT_EQ(RunPhantom("--help"), 1);
  EXPECT_EQ(RunPhantom(folder.File("a.mha") + " --size huge"), 1);
  for (const char* size : { "", "1", "8193", "-5", "12x", "99999999999" })
  {
    EXPECT_EQ(RunPhantom(folder.File("a.mha") + " --trabeculae " + size), 1) << size;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.File("a.mha")));
}

TEST(Phantom, LeavesNothingWhereItCannotWrite)
{
  const TemporaryFolder folder;
  EXPECT_EQ(RunPhantom(folder.File("missing/a.mha") + " --size small"), 3);
  std::filesystem::create_directory(folder.File("a.mha"));
  EXPECT_EQ(RunPhantom(folder.File("a.mha") + " --size small"), 3);
  EXPECT_FALSE(std::filesystem::exists(folder.File("a.mha.partial")));
}
}
}
