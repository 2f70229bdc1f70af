// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFiles.h"
#include "Layers/BoneSlabs.h"
#include "Layers/SlabReader.h"
#include "OutwardContour.h"
#include "Specimen.h"
#include "SurfaceChecks.h"
#include "VolumeFile.h"
#include "VolumeFiles.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>

namespace bonedecimate::testing
{
namespace
{
using Triangle = std::array<Vector3, 3>;

/// The corners of all triangles, from the least one of each on.
void AppendTriangles(vtkPolyData* surface, std::vector<Triangle>& triangles)
{
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    surface->GetPolys()->GetCellAtId(cell, size, ids);
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
    {
      surface->GetPoint(ids[k], triangle[k].data());
    }
    std::rotate(
      triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.push_back(triangle);
  }
}

/// Two slabs after each other may differ by a layer.
std::vector<std::int64_t> LastLayersOfSlabs(std::int64_t layers)
{
  std::vector<std::int64_t> last;
  for (std::int64_t next = 1, step = 1; next < layers - 1; next += step, step = step % 3 + 1)
  {
    last.push_back(next);
  }
  last.push_back(layers - 1);
  return last;
}

/// The voxels of a volume read in slabs, without those that are there twice; what went wrong.
std::string VoxelsOfSlabs(const std::string& path, const VoxelSpacing& spacing, std::string& voxels)
{
  volume::SlabReader reader(volume::OpenVolume(path, spacing));
  const volume::VolumeHeader& header = reader.GetHeader();
  if (!header.Problem.empty())
  {
    return header.Problem;
  }
  const std::size_t layer = header.BytesInALayer();
  for (const std::int64_t last : LastLayersOfSlabs(header.Size[2]))
  {
    const volume::Volume slab = reader.ReadTo(last);
    if (!slab.Problem.empty())
    {
      return slab.Problem;
    }
    EXPECT_EQ(slab.Image->GetExtent()[5], last);
    const char* bytes = static_cast<const char*>(slab.Image->GetScalarPointer());
    const std::size_t count = layer * static_cast<std::size_t>(slab.Image->GetDimensions()[2]);
    EXPECT_TRUE(voxels.empty() || std::memcmp(&*voxels.end() - layer, bytes, layer) == 0);
    voxels.append(bytes + (voxels.empty() ? 0 : layer), bytes + count);
  }
  EXPECT_TRUE(reader.IsAtEnd());
  return std::string();
}

/// Files of all formats that hold the scan.
std::vector<std::string> WriteAll(const TemporaryFolder& folder, const Scan& scan)
{
  std::vector<std::string> names{ "a.mha", "packed.mha", "big.mha", "a.nrrd", "packed.nrrd",
    "a.nii", "a.nii.gz", "a.vti", "slices", "dicom", "a.tif" };
  std::transform(names.begin(), names.end(), names.begin(),
    [&folder](const std::string& name) { return folder.File(name); });
  WriteMeta(names[0], scan);
  WriteCompressedMeta(names[1], scan, Deflated(VoxelBytes(scan)));
  WriteBytes(names[2],
    MetaHeader(scan, "BinaryDataByteOrderMSB = True\n") + "ElementDataFile = LOCAL\n" +
      VoxelBytes(scan, true));
  WriteNrrd(names[3], scan);
  WriteBytes(names[4],
    NrrdHeader(scan, "left-posterior-superior", "gzip") + "\n" + Gzipped(VoxelBytes(scan)));
  WriteNifti(names[5], scan);
  WriteNifti(names[6], scan);
  WriteVti(names[7], scan);
  std::filesystem::create_directory(names[8]);
  for (std::size_t k = 0; k < scan.Size[2]; ++k)
  {
    WriteBytes(names[8] + "/s" + std::to_string(k) + ".tif", TiffBytes(scan, k, 1));
  }
  std::filesystem::create_directory(names[9]);
  WriteDicom(names[9], scan);
  WriteBytes(names[10], TiffBytes(scan, 0, scan.Size[2]));
  return names;
}

TEST(Slabs, HaveTheVoxelsOfTheWholeInEveryFormat)
{
  const TemporaryFolder folder;
  const Scan scan = UprightScan();
  const VoxelSpacing spacing{ { 0.8, 0.9, 1.3 } };
  for (const std::string& path : WriteAll(folder, scan))
  {
    const volume::Volume whole = volume::ReadVolume(path, spacing);
    ASSERT_EQ(whole.Problem, "") << path;
    std::string voxels;
    ASSERT_EQ(VoxelsOfSlabs(path, spacing, voxels), "") << path;
    const auto count = static_cast<std::size_t>(whole.Image->GetNumberOfPoints());
    ASSERT_EQ(voxels.size(), count * static_cast<std::size_t>(whole.Image->GetScalarSize()));
    EXPECT_EQ(std::memcmp(voxels.data(), whole.Image->GetScalarPointer(), voxels.size()), 0)
      << path;
    const bool isDicom = whole.Image->GetScalarType() == VTK_FLOAT;
    EXPECT_TRUE(isDicom || voxels == VoxelBytes(scan)) << path;
  }
}

TEST(Slabs, FormatsWithoutSingleLayersSayThatTheyAreReadWhole)
{
  const TemporaryFolder folder;
  for (const std::string& path : WriteAll(folder, UprightScan()))
  {
    const std::string name = std::filesystem::path(path).filename().string();
    const bool isWhole =
      volume::OpenVolume(path, VoxelSpacing{ { 1.0, 1.0, 1.0 } })->GetHeader().IsReadWhole;
    EXPECT_EQ(isWhole, name == "a.vti" || name == "a.tif") << name;
  }
}

TEST(Slabs, AReaderThatIsNotReadToTheEndEndsItsProcess)
{
  const TemporaryFolder folder;
  WriteMeta(folder.File("a.mha"), UprightScan());
  for (int time = 0; time < 3; ++time)
  {
    volume::SlabReader reader(volume::OpenVolume(folder.File("a.mha")));
    EXPECT_EQ(reader.ReadTo(2).Problem, "");
  }
}

TEST(Slabs, AFileThatIsCutOffIsRejectedAsByTheWhole)
{
  const TemporaryFolder folder;
  const VoxelSpacing spacing{ { 0.8, 0.9, 1.3 } };
  for (const std::string& path : WriteAll(folder, UprightScan()))
  {
    if (!std::filesystem::is_directory(path))
    {
      std::filesystem::resize_file(path, std::filesystem::file_size(path) * 2 / 3);
      const std::string problem = volume::ReadVolume(path, spacing).Problem;
      std::string voxels;
      EXPECT_NE(problem, "") << path;
      EXPECT_EQ(VoxelsOfSlabs(path, spacing, voxels), problem) << path;
    }
  }
}

TEST(Slabs, ADamagedSliceIsNamedWhenItsTurnComes)
{
  const TemporaryFolder folder;
  const VoxelSpacing spacing{ { 0.8, 0.9, 1.3 } };
  const std::string slices = WriteAll(folder, UprightScan())[8];
  std::filesystem::resize_file(slices + "/s9.tif", 200);
  volume::SlabReader reader(volume::OpenVolume(slices, spacing));
  EXPECT_EQ(reader.ReadTo(8).Problem, "");
  EXPECT_NE(reader.ReadTo(10).Problem.find("s9.tif: "), std::string::npos);
}

TEST(SlabSurfaces, JoinedTheyAreThatOfTheWholeBitForBit)
{
  const TemporaryFolder folder;
  const std::string path = folder.File("a.mha");
  for (const Scan& scan : { UprightScan(), TiltedScan(), MirroredScan(), ShearedScan() })
  {
    WriteMeta(path, scan);
    const BoneSurface whole = ExtractBoneSurface(path, SurfaceValue + 0.5);
    ASSERT_EQ(whole.Problem, "");
    volume::SlabReader reader(volume::OpenVolume(path));
    std::vector<Triangle> expected;
    std::vector<Triangle> joined;
    AppendTriangles(whole.Surface, expected);
    for (const std::int64_t last : LastLayersOfSlabs(reader.GetHeader().Size[2]))
    {
      AppendTriangles(volume::OutwardContour(reader.ReadTo(last), SurfaceValue + 0.5), joined);
    }
    std::sort(expected.begin(), expected.end());
    std::sort(joined.begin(), joined.end());
    EXPECT_TRUE(joined == expected) << joined.size() << " and " << expected.size() << " triangles";
  }
}

TEST(SlabSurfaces, AreDividedByTheirTrianglesAndLieBetweenTheirPlanes)
{
  const TemporaryFolder folder;
  const std::string path = folder.File("a.mha");
  WriteMeta(path, ShearedScan());
  const BoneSurface whole = ExtractBoneSurface(path, SurfaceValue + 0.5);
  BoneSlabs slabs(path, SurfaceValue + 0.5);
  ASSERT_EQ(slabs.GetProblem(), "");
  EXPECT_EQ(slabs.GetVoxelSize(), whole.VoxelSize);
  EXPECT_EQ(slabs.GetNumberOfTriangles(), 2 * whole.Surface->GetNumberOfPoints());
  const vtkIdType most = 900;
  const std::size_t count = slabs.Divide(most, 1 << 20);
  EXPECT_GT(count, 3U);
  double bottom = slabs.GetBottom();
  vtkIdType triangles = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const BoneSlab slab = slabs.ReadNext();
    ASSERT_EQ(slab.Problem, "");
    EXPECT_LE(slab.Surface->GetNumberOfPolys(), 2 * most);
    triangles += slab.Surface->GetNumberOfPolys();
    for (vtkIdType id = 0; id < slab.Surface->GetNumberOfPoints(); ++id)
    {
      Vector3 point;
      slab.Surface->GetPoint(id, point.data());
      const double position = volume::Dot(point, slabs.GetAxis());
      EXPECT_TRUE(position > bottom - 1e-4 && position < slab.Top + 1e-4);
    }
    bottom = slab.Top;
  }
  EXPECT_EQ(triangles, whole.Surface->GetNumberOfPolys());
}

TEST(SlabSurfaces, AreRejectedWithTheSentenceOfTheWhole)
{
  const TemporaryFolder folder;
  const std::string path = folder.File("a.mha");
  Scan scan = UprightScan();
  const auto expectSame = [&](double value, const std::string& words)
  {
    WriteMeta(path, scan);
    const std::string problem = ExtractBoneSurface(path, value).Problem;
    EXPECT_NE(problem.find(words), std::string::npos) << problem;
    EXPECT_EQ(BoneSlabs(path, value).GetProblem(), problem);
  };
  expectSame(1e6, "none of its voxels is above");
  expectSame(-1e6, "every one of its voxels is above");
  const std::size_t part = scan.Values.size() / 4;
  for (std::size_t i = 0; i < scan.Values.size(); ++i)
  {
    scan.Values[i] = static_cast<short>(i / part); // all labels are not in one slab
  }
  expectSame(0.5, "it is a label map with the labels 1, 2, 3");
  expectSame(226.0, "it is a label map with the labels 1, 2, 3"); // and not: none is above
  WriteMeta(path, scan);
  EXPECT_EQ(BoneSlabs(path, 0.5, LabelPolicy::AsIntensities).GetProblem(), "");
  std::replace_if(
    scan.Values.begin(), scan.Values.end(), [](short value) { return value > 1; }, short(1));
  WriteMeta(path, scan);
  EXPECT_NE(BoneSlabs(path, 0.5).GetNote(), "");
  EXPECT_EQ(BoneSlabs(path, 0.5).GetNote(), ExtractBoneSurface(path, 0.5).Note);
}

TEST(BoneSlabs, PaddingOutsideOfTheFieldOfViewIsClearedInSlabs)
{
  const TemporaryFolder folder;
  const std::string path = folder.File("a.mha");
  Scan scan = ScanOf({ { 40, 40, 20 } }, VolumeGeometry());
  for (std::size_t i = 0; i < scan.Values.size(); ++i)
  {
    const std::size_t x = i % 40;
    const std::size_t y = i / 40 % 40;
    const double radius = std::hypot(static_cast<double>(x) - 19.5, static_cast<double>(y) - 19.5);
    const bool isBone = radius < 8.0 && i / 1600 > 4 && i / 1600 < 15;
    const std::size_t noise = (7 * x + 13 * y) % 40;
    scan.Values[i] = radius > 18.3 ? short(3000) : static_cast<short>(isBone ? 1000 : noise);
  }
  WriteMeta(path, scan);
  const BoneSurface whole = ExtractBoneSurface(path, 500.0);
  EXPECT_NE(whole.Note.find("have the constant value 3000"), std::string::npos) << whole.Note;
  double bounds[6];
  whole.Surface->GetBounds(bounds);
  EXPECT_LT(bounds[1], 29.0);
  BoneSlabs slabs(path, 500.0);
  EXPECT_EQ(slabs.GetNote(), whole.Note);
  const std::size_t count = slabs.Divide(1000, 1 << 20);
  EXPECT_GT(count, 1U);
  vtkIdType triangles = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const BoneSlab slab = slabs.ReadNext();
    ASSERT_EQ(slab.Problem, "");
    triangles += slab.Surface->GetNumberOfPolys();
  }
  EXPECT_EQ(triangles, whole.Surface->GetNumberOfPolys());
}
}
}
