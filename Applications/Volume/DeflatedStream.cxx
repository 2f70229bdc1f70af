// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DeflatedStream.h"

#include <algorithm>
#include <fstream>
#include <vector>
#include <zlib.h>

namespace bonedecimate::volume
{
namespace
{
constexpr std::size_t Piece = std::size_t(1) << 18;
constexpr unsigned char FirstByteOfGzip = 0x1f;

/// Inflates piece by piece, because zlib counts bytes in 32 bits, and keeps nothing.
class Inflater
{
public:
  Inflater(std::ifstream& file, std::uint64_t size)
    : File(file)
    , Rest(size)
  {
    this->Status = inflateInit2(&this->Stream, 15 + 32); // zlib or gzip
  }
  ~Inflater() { inflateEnd(&this->Stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  std::optional<std::uint64_t> CountBytes()
  {
    std::uint64_t count = 0;
    while (this->Status == Z_OK)
    {
      this->Refill();
      this->Stream.next_out = this->Inflated.data();
      this->Stream.avail_out = static_cast<uInt>(Piece);
      this->Status = inflate(&this->Stream, Z_NO_FLUSH);
      count += Piece - this->Stream.avail_out;
      if (this->Status == Z_STREAM_END && this->HasAnotherMember())
      {
        this->Status = inflateReset(&this->Stream);
      }
    }
    return this->Status == Z_STREAM_END ? std::optional(count) : std::nullopt;
  }

private:
  void Refill()
  {
    if (this->Stream.avail_in == 0)
    {
      const auto wanted = std::min<std::uint64_t>(Piece, this->Rest);
      this->File.read(
        reinterpret_cast<char*>(this->Packed.data()), static_cast<std::streamsize>(wanted));
      const auto count = static_cast<std::uint64_t>(this->File.gcount());
      this->Rest = count < wanted ? 0 : this->Rest - count;
      this->Stream.next_in = this->Packed.data();
      this->Stream.avail_in = static_cast<uInt>(count);
    }
  }

  bool HasAnotherMember()
  {
    this->Refill();
    return this->Stream.avail_in > 0 && *this->Stream.next_in == FirstByteOfGzip;
  }

  std::ifstream& File;
  std::uint64_t Rest; // bytes of the stream that are not read yet
  std::vector<Bytef> Packed = std::vector<Bytef>(Piece);
  std::vector<Bytef> Inflated = std::vector<Bytef>(Piece);
  z_stream Stream{};
  int Status = Z_OK;
};
}

std::optional<std::uint64_t> InflatedSize(
  const std::string& path, std::uint64_t begin, std::uint64_t size)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(begin));
  return file ? Inflater(file, size).CountBytes() : std::nullopt;
}
}
