// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilePath.h"
#include "ImageFiles.h"

#include "DataFile.h"
#include "DeflatedStream.h"
#include "HeaderUnit.h"
#include "IntensityChecks.h"
#include "ItkImage.h"
#include "Options/Text.h"
#include "StoredVoxels.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <locale>
#include <map>
#include <sstream>
#include <vector>
#include <zlib.h>

namespace bonedecimate::volume
{
namespace
{
/// Reads a file as niftilib does, compressed or not.
class NiftiBytes
{
public:
  explicit NiftiBytes(const std::string& path)
    : File(gzopen(path.c_str(), "rb"))
  {
  }
  ~NiftiBytes() { gzclose(this->File); }
  NiftiBytes(const NiftiBytes&) = delete;
  NiftiBytes& operator=(const NiftiBytes&) = delete;

  /// From there on; fewer where the file ends.
  const std::vector<unsigned char>& Read(std::uint64_t count)
  {
    this->Bytes.resize(count);
    const int done = gzread(this->File, this->Bytes.data(), static_cast<unsigned int>(count));
    this->Bytes.resize(static_cast<std::size_t>(std::max(done, 0)));
    return this->Bytes;
  }

  bool GoTo(std::uint64_t position)
  {
    return gzseek(this->File, static_cast<z_off_t>(position), SEEK_SET) >= 0;
  }

  static constexpr std::uint64_t Piece = std::uint64_t(1) << 18;

private:
  gzFile File;
  std::vector<unsigned char> Bytes;
};

/// The first bytes as they are in the file: niftilib replaces what it does not understand.
class NiftiHeader
{
public:
  explicit NiftiHeader(const std::string& path)
    : Bytes(NiftiBytes(path).Read(Size))
  {
    this->IsSwapped = this->Bytes.size() == Size && this->At<std::int32_t>(0) != Size;
  }

  bool IsWhole() const { return this->Bytes.size() == Size && this->At<std::int32_t>(0) == Size; }

  template <typename Number>
  Number At(std::size_t position) const
  {
    unsigned char bytes[sizeof(Number)];
    std::copy_n(this->Bytes.data() + position, sizeof(Number), bytes);
    if (this->IsSwapped)
    {
      std::reverse(std::begin(bytes), std::end(bytes));
    }
    Number number;
    std::memcpy(&number, bytes, sizeof(Number));
    return number;
  }

  /// What is wrong with it, or an empty text.
  std::string Problem() const
  {
    if (this->IsSecondVersion())
    {
      return "it is a NIfTI-2 file, which is not read; save it as NIfTI-1";
    }
    if (!this->IsWhole())
    {
      return "it is not a NIfTI-1 file";
    }
    for (const std::size_t position : { 80, 84, 88 })
    {
      const float spacing = this->At<float>(position);
      if (!(spacing > 0.0F) || std::isinf(spacing))
      {
        return "its spacing is zero, negative or not a finite number";
      }
    }
    if (std::memcmp(this->Bytes.data() + 344, "ni1", 4) == 0)
    {
      return "its voxels lie in another file (.img); save both as one .nii";
    }
    return UnitProblem(this->Unit());
  }

  HeaderUnit Unit() const
  {
    // The unit of length is in the lowest three bits; 0 is unknown.
    constexpr const char* units[] = { "", "m", "mm", "um", "4", "5", "6", "7" };
    return UnitOf(units[this->At<unsigned char>(123) & 7]);
  }

  /// Whether the voxels lie behind it and have no scale.
  bool HasPlainVoxels() const
  {
    const float slope = this->At<float>(112);
    const float intercept = this->At<float>(116);
    return std::memcmp(this->Bytes.data() + 344, "n+1", 4) == 0 && intercept == 0.0F &&
      (slope == 0.0F || slope == 1.0F);
  }

  ByteOrder Order() const
  {
    return this->Bytes.front() == 0 ? ByteOrder::Big : ByteOrder::Little; // of 348
  }

  std::uint64_t BeginOfVoxels() const
  {
    const float offset = this->At<float>(108);
    return offset > Size && offset < 1e9F ? static_cast<std::uint64_t>(offset) : Size;
  }

private:
  /// Its header has 540 bytes, in either byte order.
  bool IsSecondVersion() const
  {
    const std::string first(this->Bytes.begin(), this->Bytes.end());
    return first.compare(0, 4, "\x1c\x02\0\0", 4) == 0 ||
      first.compare(0, 4, "\0\0\x02\x1c", 4) == 0;
  }

  static constexpr int Size = 348;

  std::vector<unsigned char> Bytes;
  bool IsSwapped = false;
};

bool HasSform(const NiftiHeader& header)
{
  return header.At<std::int16_t>(254) > 0;
}

bool HasQform(const NiftiHeader& header)
{
  return header.At<std::int16_t>(252) > 0;
}

/// mm
VolumeGeometry SformOf(const NiftiHeader& header)
{
  VolumeGeometry geometry;
  for (std::size_t row = 0; row < 3; ++row)
  {
    const double sign = row < 2 ? -1.0 : 1.0; // RAS to LPS
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      geometry.Steps[axis][row] = sign * double(header.At<float>(280 + 16 * row + 4 * axis));
    }
    geometry.Origin[row] = sign * double(header.At<float>(292 + 16 * row));
  }
  return InMillimeters(geometry, header.Unit());
}

/// Of a file whose position ITK takes from the sform, although its spacing is another one: from 5.3 on ITK warns only.
std::string SpacingProblem(const NiftiHeader& header)
{
  const bool isOfScanner = header.At<std::int16_t>(254) == 1;
  const bool hasQform = HasQform(header);
  const VolumeGeometry geometry = SformOf(header);
  for (std::size_t axis = 0; HasSform(header) && (isOfScanner || !hasQform) && axis < 3; ++axis)
  {
    const double spacing = header.Unit().Millimeters * double(header.At<float>(80 + 4 * axis));
    if (!(std::abs(Length(geometry.Steps[axis]) - spacing) <= 1e-3 * spacing))
    {
      return "its spacing is not that of its sform; save it with the same in both";
    }
  }
  return std::string();
}

/// Of a file whose axes ITK finds not perpendicular, which rounding to single precision suffices for.
std::string SformProblem(const NiftiHeader& header)
{
  return HasSform(header) ? GeometryProblem(SformOf(header)) : "its header has no position";
}

/// The largest coordinate of the difference of the positions of a voxel, mm.
double Distance(
  const VolumeGeometry& a, const VolumeGeometry& b, const std::array<std::int64_t, 3>& size)
{
  double largest = 0.0;
  for (std::size_t row = 0; row < 3; ++row)
  {
    double lowest = a.Origin[row] - b.Origin[row];
    double highest = lowest;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double along =
        static_cast<double>(size[axis] - 1) * (a.Steps[axis][row] - b.Steps[axis][row]);
      lowest += std::min(along, 0.0);
      highest += std::max(along, 0.0);
    }
    largest = std::max({ largest, std::abs(lowest), std::abs(highest) });
  }
  return largest;
}

std::string PositionNote(const NiftiHeader& header, const ItkHeader& read)
{
  if (!HasSform(header) && !HasQform(header))
  {
    return "its header does not say how the patient lies (sform_code and qform_code are 0): x is "
           "taken to run to the "
           "left and y to the back, as ITK does; nibabel and FSL let y run to the front, so the "
           "surface may be mirrored";
  }
  const auto& steps = read.Geometry.Steps;
  const double spacing = std::min({ Length(steps[0]), Length(steps[1]), Length(steps[2]) });
  const double distance =
    HasSform(header) ? Distance(read.Geometry, SformOf(header), read.Size) : 0.0;
  if (distance <= 0.1 * spacing)
  {
    return std::string();
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "its sform and qform are up to " << distance
       << " mm apart; positions are those of its qform";
  return text.str();
}

/// How the voxels are stored, which is not always how they are read.
struct StoredType
{
  std::size_t Bytes = 0;
  bool IsFloatingPoint = false;
};

/// Of the types that the format numbers so and ITK reads.
StoredType TypeOf(std::int64_t datatype)
{
  static const std::map<std::int64_t, StoredType> types{ { 2, { 1, false } }, { 4, { 2, false } },
    { 8, { 4, false } }, { 16, { 4, true } }, { 64, { 8, true } }, { 256, { 1, false } },
    { 512, { 2, false } }, { 768, { 4, false } }, { 1024, { 8, false } }, { 1280, { 8, false } } };
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

/// Whether ITK's voxels are the numbers in the file.
bool AreStored(const NiftiHeader& header, const ItkHeader& read)
{
  const StoredType stored = TypeOf(header.At<std::int16_t>(70));
  const bool isFloatingPoint = read.ScalarType == VTK_FLOAT || read.ScalarType == VTK_DOUBLE;
  return header.HasPlainVoxels() && stored.IsFloatingPoint == isFloatingPoint &&
    vtkDataArray::GetDataTypeSize(read.ScalarType) == static_cast<int>(stored.Bytes);
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
  std::string inFile = FirstOf({ NameProblem(path), header.Problem() });
  inFile = inFile.empty() ? SpacingProblem(header) : inFile;
  if (!inFile.empty())
  {
    return RejectedLayers(inFile);
  }
  ItkImage image(ItkImage::Format::Nifti, path);
  const ItkHeader& read = image.GetHeader();
  const std::string problem = FirstOf({ read.Problem, ComponentsProblem(read),
    read.HasGeometry ? std::string() : SformProblem(header) });
  const std::string ofVoxels = problem.empty() ? VoxelsProblem(header, read, path) : problem;
  if (!ofVoxels.empty())
  {
    return RejectedLayers(ofVoxels);
  }
  LayeredVolume volume = AreStored(header, read)
    ? StoredLayers(read, DataOf(header, path), header.Order())
    : LayersOf(image.ReadVolume());
  if (read.HasGeometry)
  {
    volume.Header.Note = PositionNote(header, read);
  }
  else
  {
    volume.Header.Geometry = SformOf(header);
  }
  AppendNote(volume.Header.Note, UnitNote(header.Unit()));
  return volume;
}
}
