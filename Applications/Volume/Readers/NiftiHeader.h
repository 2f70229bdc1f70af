// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NiftiHeader.h
 * @brief The header of a NIfTI file as its bytes are.
 */
#ifndef BoneDecimate_Applications_NiftiHeader_h
#define BoneDecimate_Applications_NiftiHeader_h

#include "HeaderUnit.h"
#include "StoredVoxels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>
#include <zlib.h>

namespace bonedecimate::volume
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

  /// Reads the next bytes; returns fewer at the end of the file.
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
    if (!(this->At<float>(108) >= float(Size)))
    {
      return "its voxels begin inside its header by vox_offset, and readers disagree where they "
             "are; save it again as .nii";
    }
    return UnitProblem(this->Unit());
  }

  HeaderUnit Unit() const
  {
    // The unit of length is in the lowest three bits; 0 is unknown.
    constexpr const char* units[] = { "", "m", "mm", "um", "4", "5", "6", "7" };
    return UnitOf(units[this->At<unsigned char>(123) & 7]);
  }

  /// Whether values are scaled. Without a slope, an intercept does not count.
  bool HasScale() const
  {
    const float slope = this->At<float>(112);
    const float intercept = this->At<float>(116);
    return std::isfinite(slope) && slope != 0.0F && (slope != 1.0F || intercept != 0.0F);
  }

  /// Whether the voxels lie behind it and have no scale.
  bool HasPlainVoxels() const
  {
    return std::memcmp(this->Bytes.data() + 344, "n+1", 4) == 0 && !this->HasScale();
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
}

#endif
