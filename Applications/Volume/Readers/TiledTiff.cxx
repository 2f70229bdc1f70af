// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TiledTiff.h"

#include "DataFile.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cstring>
#include <tiffio.h>
#include <vector>

namespace bonedecimate::volume
{
namespace
{
template <typename Number>
Number TiffField(tiff* file, std::uint32_t tag)
{
  Number value = 0;
  TIFFGetFieldDefaulted(file, tag, &value);
  return value;
}

int TypeOfSamples(int format, int bits)
{
  switch (bits)
  {
    case 8:
      return format == SAMPLEFORMAT_INT ? VTK_SIGNED_CHAR
        : format == SAMPLEFORMAT_UINT   ? VTK_UNSIGNED_CHAR
                                        : VTK_VOID;
    case 16:
      return format == SAMPLEFORMAT_INT ? VTK_SHORT
        : format == SAMPLEFORMAT_UINT   ? VTK_UNSIGNED_SHORT
                                        : VTK_VOID;
    case 32:
      return format == SAMPLEFORMAT_INT ? VTK_INT
        : format == SAMPLEFORMAT_UINT   ? VTK_UNSIGNED_INT
        : format == SAMPLEFORMAT_IEEEFP ? VTK_FLOAT
                                        : VTK_VOID;
    default:
      return VTK_VOID;
  }
}
}

TiledTiff::TiledTiff(const std::string& path)
  : File(TIFFOpen(path.c_str(), "r"))
{
  this->Header.Problem = this->File ? this->ReadHeader(path) : "it is not a TIFF file";
}

TiledTiff::~TiledTiff()
{
  if (this->File)
  {
    TIFFClose(this->File);
  }
}

std::string TiledTiff::ReadHeader(const std::string& path)
{
  this->Header.Size = { { TiffField<std::uint32_t>(this->File, TIFFTAG_IMAGEWIDTH),
    TiffField<std::uint32_t>(this->File, TIFFTAG_IMAGELENGTH), 1 } };
  this->Header.Components = TiffField<std::uint16_t>(this->File, TIFFTAG_SAMPLESPERPIXEL);
  this->Header.ScalarType =
    TypeOfSamples(TiffField<std::uint16_t>(this->File, TIFFTAG_SAMPLEFORMAT),
      TiffField<std::uint16_t>(this->File, TIFFTAG_BITSPERSAMPLE));
  const std::string components = ComponentsProblem(this->Header);
  if (!components.empty())
  {
    return components;
  }
  if (TiffField<std::uint16_t>(this->File, TIFFTAG_PHOTOMETRIC) != PHOTOMETRIC_MINISBLACK ||
    this->Header.ScalarType == VTK_VOID)
  {
    return "its voxels are no gray values of 8, 16 or 32 bits with black at 0";
  }
  const std::uint32_t least = 2;
  const auto bytes =
    static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(this->Header.ScalarType));
  if (TIFFIsTiled(this->File) == 0)
  {
    return TIFFScanlineSize64(this->File) ==
        static_cast<std::uint64_t>(this->Header.Size[0]) * bytes
      ? SizeProblem(
          { { this->Header.Size[0], this->Header.Size[1], least } }, 1, SizeOfFile(path), true)
      : "its strips are damaged";
  }
  // A tile may be larger than its page.
  const auto width = TiffField<std::uint32_t>(this->File, TIFFTAG_TILEWIDTH);
  const auto length = TiffField<std::uint32_t>(this->File, TIFFTAG_TILELENGTH);
  if (TIFFTileSize64(this->File) != std::uint64_t(width) * length * bytes)
  {
    return "its tiles are three-dimensional or damaged";
  }
  return SizeProblem(
    { { std::max(width, least), std::max(length, least), least } }, 1, SizeOfFile(path), true);
}

bool TiledTiff::ReadVoxels(void* values)
{
  if (this->PagesRead++ > 0 && !TIFFReadDirectory(this->File))
  {
    return false;
  }
  return TIFFIsTiled(this->File) != 0 ? this->ReadTiles(values) : this->ReadRows(values);
}

bool TiledTiff::ReadRows(void* values)
{
  const auto rows = static_cast<std::uint32_t>(this->Header.Size[1]);
  const std::size_t bytes = static_cast<std::size_t>(this->Header.Size[0]) *
    static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(this->Header.ScalarType));
  if (TIFFScanlineSize64(this->File) != bytes)
  {
    return false;
  }
  for (std::uint32_t row = 0; row < rows; ++row)
  {
    if (TIFFReadScanline(this->File, static_cast<char*>(values) + row * bytes, row, 0) < 0)
    {
      return false;
    }
  }
  return true;
}

bool TiledTiff::ReadTiles(void* values)
{
  const auto width = TiffField<std::uint32_t>(this->File, TIFFTAG_TILEWIDTH);
  const auto length = TiffField<std::uint32_t>(this->File, TIFFTAG_TILELENGTH);
  const auto columns = static_cast<std::uint32_t>(this->Header.Size[0]);
  const auto rows = static_cast<std::uint32_t>(this->Header.Size[1]);
  const auto bytes =
    static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(this->Header.ScalarType));
  const std::size_t tileBytes = std::size_t(width) * length * bytes;
  if (width == 0 || length == 0 || TIFFTileSize64(this->File) != tileBytes)
  {
    return false;
  }
  std::vector<char> tile(tileBytes);
  for (std::uint32_t y = 0; y < rows; y += std::min(length, rows - y))
  {
    for (std::uint32_t x = 0; x < columns; x += std::min(width, columns - x))
    {
      if (TIFFReadTile(this->File, tile.data(), x, y, 0, 0) < 0)
      {
        return false;
      }
      for (std::uint32_t row = 0; row < std::min(length, rows - y); ++row)
      {
        char* const to =
          static_cast<char*>(values) + ((std::size_t(y) + row) * columns + x) * bytes;
        std::memcpy(
          to, tile.data() + std::size_t(row) * width * bytes, std::min(width, columns - x) * bytes);
      }
    }
  }
  return true;
}
}
