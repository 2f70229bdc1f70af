// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RawVoxels.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>
#include <zlib.h>

namespace bonedecimate::volume
{
namespace
{
#ifdef VTK_WORDS_BIGENDIAN
constexpr bool IsHostBigEndian = true;
#else
constexpr bool IsHostBigEndian = false;
#endif

/// Inflates into a buffer piece by piece: zlib counts bytes in 32 bits.
class Inflater
{
public:
  Inflater() { this->Status = inflateInit2(&this->Stream, 15 + 32); } // zlib or gzip
  ~Inflater() { inflateEnd(&this->Stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// True if the file holds exactly that many bytes and its checksum is right.
  bool Fill(std::ifstream& file, char* bytes, std::size_t count)
  {
    char spare = 0; // space for zlib to come to the end of the stream
    std::size_t done = 0;
    while (done <= count && this->Status == Z_OK)
    {
      this->Refill(file);
      const std::size_t space = done < count ? std::min(Piece, count - done) : 1;
      this->Stream.next_out = reinterpret_cast<Bytef*>(done < count ? bytes + done : &spare);
      this->Stream.avail_out = static_cast<uInt>(space);
      this->Status = inflate(&this->Stream, Z_NO_FLUSH);
      done += space - this->Stream.avail_out;
    }
    return done == count && this->Status == Z_STREAM_END;
  }

private:
  static constexpr std::size_t Piece = std::size_t(1) << 20;

  void Refill(std::ifstream& file)
  {
    if (this->Stream.avail_in == 0)
    {
      file.read(this->Packed.data(), static_cast<std::streamsize>(Piece));
      this->Stream.next_in = reinterpret_cast<Bytef*>(this->Packed.data());
      this->Stream.avail_in = static_cast<uInt>(file.gcount());
    }
  }

  std::vector<char> Packed = std::vector<char>(Piece);
  z_stream Stream{};
  int Status = Z_OK;
};

bool FillVoxels(std::ifstream& file, bool isCompressed, char* bytes, std::size_t count)
{
  if (isCompressed)
  {
    return Inflater().Fill(file, bytes, count);
  }
  file.read(bytes, static_cast<std::streamsize>(count));
  return static_cast<std::size_t>(file.gcount()) == count;
}
}

VoxelLayout RejectedLayout(const std::string& problem)
{
  VoxelLayout layout;
  layout.Problem = problem;
  return layout;
}

Volume ReadVoxels(const VoxelLayout& layout)
{
  std::error_code error;
  const std::uintmax_t fileSize = std::filesystem::file_size(layout.DataFile, error);
  if (error)
  {
    const std::string name = std::filesystem::path(layout.DataFile).filename().string();
    return RejectedVolume("the file of its voxels, " + name + ", cannot be read");
  }
  const bool isAtEnd = layout.BytesBefore < 0 && !layout.IsCompressed;
  const std::uintmax_t before =
    std::min(static_cast<std::uintmax_t>(std::max<std::int64_t>(layout.BytesBefore, 0)), fileSize);
  const int bytesPerVoxel = vtkDataArray::GetDataTypeSize(layout.ScalarType);
  const std::string problem =
    SizeProblem(layout.Size, bytesPerVoxel, fileSize - before, layout.IsCompressed);
  if (!problem.empty())
  {
    return RejectedVolume(problem);
  }
  Volume volume;
  volume.Geometry = layout.Geometry;
  volume.IsSegmentation = layout.IsSegmentation;
  volume.Image = AllocateImage(layout.Size, layout.ScalarType);
  const auto voxels = static_cast<std::size_t>(volume.Image->GetNumberOfPoints());
  const std::size_t bytes = voxels * static_cast<std::size_t>(bytesPerVoxel);
  std::ifstream file(layout.DataFile, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(isAtEnd ? fileSize - bytes : before));
  char* values = static_cast<char*>(volume.Image->GetScalarPointer());
  if (!FillVoxels(file, layout.IsCompressed, values, bytes))
  {
    return RejectedVolume("its voxels are truncated or damaged");
  }
  if (layout.IsBigEndian != IsHostBigEndian && bytesPerVoxel > 1)
  {
    vtkByteSwap::SwapVoidRange(values, voxels, static_cast<std::size_t>(bytesPerVoxel));
  }
  return volume;
}
}
