// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Specimen.h"
#include "SurfaceChecks.h"
#include "VolumeFiles.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkXMLImageDataWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

namespace bonedecimate::testing
{
namespace
{
/// Replaces a text that must occur.
std::string Replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t position = text.find(from);
  EXPECT_NE(position, std::string::npos) << from;
  return position == std::string::npos ? text : text.replace(position, from.size(), to);
}

class VolumeRejects : public ::testing::Test
{
protected:
  /// A file of this name with these bytes is rejected with these words.
  void Expect(const std::string& name, const std::string& bytes, const std::string& words)
  {
    WriteBytes(this->Folder.File(name), bytes);
    ExpectRejection(this->Folder.File(name), words);
  }

  std::string Meta(const std::string& from, const std::string& to) const
  {
    return Replaced(MetaHeader(this->Upright), from, to) + "ElementDataFile = LOCAL\n" +
      VoxelBytes(this->Upright);
  }

  std::string Nrrd(const std::string& from, const std::string& to) const
  {
    return Replaced(NrrdHeader(this->Upright, "left-posterior-superior", "raw"), from, to) + "\n" +
      VoxelBytes(this->Upright);
  }

  std::string Vti()
  {
    WriteVti(this->Folder.File("whole.vti"), this->Upright);
    return ReadBytes(this->Folder.File("whole.vti"));
  }

  TemporaryFolder Folder;
  Scan Upright = UprightScan();
};

TEST_F(VolumeRejects, MissingFile)
{
  for (const char* name : { "no.vti", "no.mha", "no.nrrd", "no" })
  {
    ExpectRejection(this->Folder.File(name), "there is no such file");
  }
}

TEST_F(VolumeRejects, EmptyFile)
{
  for (const char* name :
    { "a.vti", "a.mha", "a.mhd", "a.nrrd", "a.nhdr", "a.nii", "a.nii.gz", "a.tif" })
  {
    this->Expect(name, "", "is empty");
  }
}

TEST_F(VolumeRejects, AnythingElse)
{
  this->Expect("a.stl", "solid", "is no volume");
  std::filesystem::create_directory(this->Folder.File("folder"));
  ExpectRejection(this->Folder.File("folder"), "is no volume");
}

TEST_F(VolumeRejects, BytesThatAreNoVolume)
{
  const char bytes[] = "\x7f\x01\xfe garbage \x00\xff without end";
  const std::string noise(bytes, sizeof(bytes) - 1);
  this->Expect("a.vti", noise, "not a VTK image");
  this->Expect("a.mha", noise, "no header");
  this->Expect("a.nrrd", noise, "header is damaged");
  this->Expect("a.nii", noise, "not a NIfTI-1 file");
  this->Expect("a.tif", noise, "--spacing");
  this->Expect("b.mha", std::string(std::size_t(5) << 20, 'x'), "no header");
  this->Expect("b.nrrd", "NRRD0004\n" + std::string(std::size_t(5) << 20, 'x'), "is damaged");
}

TEST_F(VolumeRejects, SurfaceThatCallsItselfVolume)
{
  this->Expect("a.vti",
    "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"0.1\"><PolyData/></VTKFile>",
    "not a VTK image");
}

TEST_F(VolumeRejects, TruncatedVoxels)
{
  const std::string meta = this->Meta("NDims", "NDims");
  const std::string nrrd = this->Nrrd("type", "type");
  this->Expect("a.mha", meta.substr(0, meta.size() - 1), "truncated");
  this->Expect("a.nrrd", nrrd.substr(0, nrrd.size() - 1), "truncated");
  this->Expect("b.nrrd", nrrd.substr(0, 100), "header is damaged");
  const std::string vti = this->Vti();
  this->Expect("a.vti", vti.substr(0, vti.size() / 2), "truncated or damaged");
}

TEST_F(VolumeRejects, DamagedCompressedVoxels)
{
  const std::string voxels = VoxelBytes(this->Upright);
  std::string flipped = Deflated(voxels);
  flipped[flipped.size() - 2] ^= 0x10; // in the checksum
  std::string gzipFlipped = Gzipped(voxels);
  gzipFlipped[gzipFlipped.size() - 6] ^= 0x10;
  const std::string nrrd = NrrdHeader(this->Upright, "left-posterior-superior", "gzip") + "\n";
  for (const auto& [deflated, gzipped] : { std::pair(flipped, gzipFlipped),
         std::pair(Deflated(voxels).substr(0, 9000), Gzipped(voxels).substr(0, 9000)),
         std::pair(Deflated(voxels + "more"), Gzipped(voxels + "more")) })
  {
    WriteCompressedMeta(this->Folder.File("a.mha"), this->Upright, deflated);
    ExpectRejection(this->Folder.File("a.mha"), "truncated or damaged");
    this->Expect("a.nrrd", nrrd + gzipped, "truncated or damaged");
  }
  this->Expect("b.mha",
    MetaHeader(this->Upright, "CompressedData = True\n") + "ElementDataFile = LOCAL\n" +
      Deflated(voxels),
    "how many bytes");
  this->Expect("c.mha",
    MetaHeader(this->Upright, "CompressedData = True\nCompressedDataSize = 9000\n") +
      "ElementDataFile = LOCAL\n" + Deflated(voxels),
    "truncated or damaged");
}

TEST_F(VolumeRejects, HugeSizesWithoutAskingForTheMemory)
{
  const std::string size = "50 52 40";
  this->Expect(
    "a.mha", this->Meta("DimSize = " + size, "DimSize = 100000 100000 100000"), "cannot hold");
  this->Expect("b.mha", this->Meta("DimSize = " + size, "DimSize = 99999999999 2 2"), "announces");
  this->Expect("c.mha", this->Meta("DimSize = " + size, "DimSize = 99999999999999999999 2 2"), "");
  this->Expect("a.nrrd", this->Nrrd("sizes: " + size, "sizes: 2000000000 2000000000 2000000000"),
    "header is damaged");
  this->Expect("b.nrrd", this->Nrrd("sizes: " + size, "sizes: 20000 20000 20000"), "cannot hold");
  const std::string packed =
    MetaHeader(this->Upright, "CompressedData = True\nCompressedDataSize = 5000\n");
  this->Expect("d.mha",
    Replaced(packed, size, "90000 90000 90000") + "ElementDataFile = LOCAL\n" +
      Deflated(VoxelBytes(this->Upright)),
    "cannot hold");
  const std::string extent = "WholeExtent=\"3 52 0 51 0 39\"";
  const std::string piece = "Piece Extent=\"3 52 0 51 0 39\"";
  std::string vti = Replaced(this->Vti(), extent, "WholeExtent=\"0 99999 0 99999 0 99999\"");
  vti = Replaced(vti, piece, "Piece Extent=\"0 99999 0 99999 0 99999\"");
  this->Expect("a.vti", vti, "cannot hold");
}

TEST_F(VolumeRejects, SizesOfLessThanTwo)
{
  this->Expect("a.mha", this->Meta("50 52 40", "50 52 1"), "at least two");
  this->Expect("b.mha", this->Meta("50 52 40", "50 0 40"), "at least two");
  this->Expect("c.mha", this->Meta("50 52 40", "50 -52 40"), "at least two");
  this->Expect("d.mha", this->Meta("50 52 40", "50 52"), "DimSize");
}

TEST_F(VolumeRejects, MoreThanOneValueAVoxel)
{
  this->Expect(
    "a.mha", this->Meta("NDims = 3", "NDims = 3\nElementNumberOfChannels = 3"), "3 values");
  this->Expect("a.nrrd", this->Nrrd("dimension: 3", "dimension: 4"), "header is damaged");
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 3 * 64, 0);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(this->Folder.File("a.vti").c_str());
  writer->SetInputData(image);
  writer->Write();
  ExpectRejection(this->Folder.File("a.vti"), "no array of one value a voxel");
}

TEST_F(VolumeRejects, GeometryThatIsNone)
{
  this->Expect(
    "a.mha", this->Meta("TransformMatrix = 1 0 0", "TransformMatrix = 0 1 0"), "in one plane");
  this->Expect("b.mha", this->Meta("TransformMatrix = 1 0 0 ", "TransformMatrix = 1 0 0 0 "),
    "TransformMatrix is not 9 numbers");
  this->Expect("c.mha", this->Meta("ElementSpacing = ", "ElementSpacing = nan nan nan\nx = "), "");
  this->Expect(
    "d.mha", this->Meta("ElementSpacing = ", "ElementSpacing = 0 1 1\nx = "), "spacing is zero");
  this->Expect(
    "f.mha", this->Meta("ElementSpacing = ", "ElementSpacing = -1 1 1\nx = "), "negative");
  this->Expect("e.mha", this->Meta("Offset = ", "Offset = here there\nx = "), "Offset");
  this->Expect(
    "a.nrrd", this->Nrrd("space directions: (", "space directions: none ("), "header is damaged");
  this->Expect("b.nrrd", this->Nrrd("left-posterior-superior", "left-posterior-superior-time"),
    "header is damaged");
  this->Expect("c.nrrd",
    this->Nrrd("endian: little", "endian: little\nspace units: \"inch\" \"inch\" \"inch\""),
    "its unit of length is 'inch': save it in millimeters");
}

TEST_F(VolumeRejects, WhatTheFormatsCanAndWeDoNot)
{
  this->Expect("a.mha", this->Meta("BinaryData = True", "BinaryData = False"), "text");
  this->Expect("b.mha", this->Meta("MET_SHORT", "MET_OTHER"), "");
  this->Expect("c.mha", this->Meta("NDims = 3", "NDims = 2"), "");
  this->Expect("a.mhd", MetaHeader(this->Upright) + "ElementDataFile = LIST\n", "several files");
  this->Expect(
    "b.mhd", MetaHeader(this->Upright) + "ElementDataFile = s%03d.raw 1 9 1\n", "several files");
  this->Expect("c.mhd", MetaHeader(this->Upright) + "ElementDataFile = gone.raw\n", "gone.raw");
  this->Expect("a.nrrd", this->Nrrd("encoding: raw", "encoding: bzip2"), "packed by bzip2");
  this->Expect("c.nrrd", this->Nrrd("encoding: raw", "encoding: ascii"), "are text by its header");
  this->Expect("a.nhdr", this->Nrrd("encoding: raw", "encoding: raw\ndata file: gone.raw"), "");
  this->Expect("b.nrrd", this->Nrrd("type: short", "type: block"), "header is damaged");
}

TEST_F(VolumeRejects, ValueThatNoVoxelOrEveryVoxelReaches)
{
  WriteMeta(this->Folder.File("a.mha"), this->Upright);
  ExpectRejection(this->Folder.File("a.mha"), "none of its voxels is above 3000 HU", 3000.0);
  ExpectRejection(this->Folder.File("a.mha"), "every one of its voxels is above -5000 HU", -5000.0);
  const double none = std::numeric_limits<double>::quiet_NaN();
  ExpectRejection(this->Folder.File("a.mha"), "not a finite number", none);
}

TEST_F(VolumeRejects, VoxelsThatAreNoNumbers)
{
  // Any short of 0x7fc0 makes a float that is not a number together with its neighbor.
  Scan scan = ScanOf({ { 20, 10, 10 } }, VolumeGeometry());
  scan.Values.assign(scan.Values.size(), 0);
  scan.Values[101] = 0x7fc0;
  scan.Values[201] = 0x7f80;
  const std::string header = Replaced(MetaHeader(scan), "MET_SHORT", "MET_FLOAT");
  this->Expect("a.mha",
    Replaced(header, "20 10 10", "10 10 10") + "ElementDataFile = LOCAL\n" + VoxelBytes(scan),
    "2 of its voxels are not finite");
}
}
}
