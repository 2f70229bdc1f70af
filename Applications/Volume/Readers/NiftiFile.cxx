// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilePath.h"
#include "ImageFiles.h"

#include "Base/Text.h"
#include "DataFile.h"
#include "DeflatedStream.h"
#include "HeaderUnit.h"
#include "IntensityChecks.h"
#include "ItkImage.h"
#include "NiftiHeader.h"
#include "NiftiPosition.h"
#include "StoredVoxels.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <vector>

namespace bonedecimate::volume
{
namespace
{
/// How the voxels are stored, which is not always how they are read.
struct StoredType
{
  std::size_t Bytes = 0;
  bool IsFloatingPoint = false;
  int ScalarType = VTK_VOID;
};

/// The type that has this number in the format, if ITK reads it.
StoredType TypeOf(std::int64_t datatype)
{
  static const std::map<std::int64_t, StoredType> types{ { 2, { 1, false, VTK_UNSIGNED_CHAR } },
    { 4, { 2, false, VTK_SHORT } }, { 8, { 4, false, VTK_INT } }, { 16, { 4, true, VTK_FLOAT } },
    { 64, { 8, true, VTK_DOUBLE } }, { 256, { 1, false, VTK_SIGNED_CHAR } },
    { 512, { 2, false, VTK_UNSIGNED_SHORT } }, { 768, { 4, false, VTK_UNSIGNED_INT } },
    { 1024, { 8, false, VTK_LONG_LONG } }, { 1280, { 8, false, VTK_UNSIGNED_LONG_LONG } } };
  const auto found = types.find(datatype);
  return found == types.end() ? StoredType() : found->second;
}

/// Whether all bits of the exponent are set.
bool IsNotFinite(const unsigned char* number, std::size_t bytes, bool isBigEndian)
{
  const unsigned int high = number[isBigEndian ? 0 : bytes - 1];
  const unsigned int low = number[isBigEndian ? 1 : bytes - 2];
  const unsigned int exponent = bytes == 4 ? 0x7f80 : 0x7ff0;
  return ((high << 8 | low) & exponent) == exponent;
}

/// Counts voxels that are no finite numbers, which niftilib takes for zeros.
std::uint64_t CountNotFinite(
  const std::string& path, std::uint64_t begin, std::uint64_t voxels, const StoredType& type)
{
  NiftiBytes file(path);
  const bool isBigEndian = file.Read(1) == std::vector<unsigned char>{ 0 }; // of 348
  std::uint64_t rest = file.GoTo(begin) ? voxels * type.Bytes : 0;
  std::uint64_t count = 0;
  while (rest > 0)
  {
    const std::vector<unsigned char>& bytes = file.Read(std::min(rest, NiftiBytes::Piece));
    for (std::size_t i = 0; i + type.Bytes <= bytes.size(); i += type.Bytes)
    {
      count += IsNotFinite(bytes.data() + i, type.Bytes, isBigEndian) ? 1 : 0;
    }
    rest = bytes.empty() ? 0 : rest - bytes.size();
  }
  return count;
}

/// By its first bytes: names are not always right.
bool IsCompressed(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return file.get() == 0x1f && file.get() == 0x8b;
}

/// ITK goes by the name.
std::string NameProblem(const std::string& path)
{
  const bool isNamedSo = LowerCase(FilePath(path).extension().string()) == ".gz";
  return IsCompressed(path) && !isNamedSo
    ? "it is compressed by gzip, but not named so: call it .nii.gz"
    : std::string();
}

std::string VoxelsProblem(const NiftiHeader& header, const ItkHeader& read, const std::string& path)
{
  const StoredType type = TypeOf(header.At<std::int16_t>(70));
  if (type.Bytes == 0)
  {
    return "the type of its voxels is not read; save them as numbers of 8, 16, 32 or 64 bits";
  }
  const bool isCompressed = IsCompressed(path);
  const std::uint64_t begin = header.BeginOfVoxels();
  const std::uint64_t bytes = SizeOfFile(path);
  const std::string problem = SizeProblem(read.Size, static_cast<int>(type.Bytes),
    isCompressed ? bytes : bytes - std::min(bytes, begin), isCompressed);
  const auto voxels = static_cast<std::uint64_t>(read.Size[0] * read.Size[1] * read.Size[2]);
  if (problem.empty() && isCompressed &&
    InflatedSize(path, 0, bytes).value_or(0) < begin + voxels * type.Bytes)
  {
    return DamagedVoxels;
  }
  const std::uint64_t notFinite =
    problem.empty() && type.IsFloatingPoint ? CountNotFinite(path, begin, voxels, type) : 0;
  return notFinite == 0 ? problem
                        : std::to_string(notFinite) + " of its voxels are not finite numbers";
}

/// ITK has another type for some voxels that have no scale: those of a slope of zero with an
/// intercept.
ItkHeader WithStoredType(const NiftiHeader& header, const ItkHeader& read)
{
  ItkHeader stored = read;
  stored.ScalarType = TypeOf(header.At<std::int16_t>(70)).ScalarType;
  return stored;
}

DataFile DataOf(const NiftiHeader& header, const std::string& path)
{
  DataFile data;
  data.Path = path;
  data.Bytes = SizeOfFile(path);
  data.IsCompressed = IsCompressed(path);
  data.Skipped = header.BeginOfVoxels();
  return data;
}
}

LayeredVolume OpenNifti(const std::string& path)
{
  const NiftiHeader header(path);
  const std::string inFile = FirstOf({ NameProblem(path), header.Problem() });
  if (!inFile.empty())
  {
    return RejectedLayers(inFile);
  }
  ItkImage image(ItkImage::Format::Nifti, path);
  const ItkHeader& read = image.GetHeader();
  const std::string problem =
    FirstOf({ PositionProblem(header, read), read.Problem, ComponentsProblem(read) });
  const std::string ofVoxels = problem.empty() ? VoxelsProblem(header, read, path) : problem;
  if (!ofVoxels.empty())
  {
    return RejectedLayers(ofVoxels);
  }
  LayeredVolume volume = header.HasPlainVoxels()
    ? StoredLayers(WithStoredType(header, read), DataOf(header, path), header.Order())
    : LayersOf(image.ReadVolume());
  volume.Header.Geometry = PositionOf(header, read);
  volume.Header.Note = PositionNote(header, volume.Header.Geometry, read.Size);
  AppendNote(volume.Header.Note, UnitNote(header.Unit()));
  return volume;
}
}
