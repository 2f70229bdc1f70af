// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DeflatedStream.h"

#include <algorithm>

namespace bonedecimate::volume
{
namespace
{
constexpr std::uint64_t Piece = std::uint64_t(1) << 18;
constexpr unsigned char FirstByteOfGzip = 0x1f;
}

DeflatedStream::DeflatedStream(const std::string& path, std::uint64_t begin, std::uint64_t size)
  : File(path, std::ios::binary)
  , Rest(size)
  , Packed(Piece)
{
  this->File.seekg(static_cast<std::streamoff>(begin));
  this->Status = inflateInit2(&this->Stream, 15 + 32); // zlib or gzip
}

/// Piece by piece, because zlib counts bytes in 32 bits.
std::uint64_t DeflatedStream::Read(void* bytes, std::uint64_t count)
{
  std::uint64_t done = 0;
  while (done < count && this->Status == Z_OK)
  {
    const std::uint64_t wanted = std::min(Piece, count - done);
    this->Refill();
    this->Stream.next_out = static_cast<Bytef*>(bytes) + done;
    this->Stream.avail_out = static_cast<uInt>(wanted);
    this->Status = inflate(&this->Stream, Z_NO_FLUSH);
    done += wanted - this->Stream.avail_out;
    if (this->Status == Z_STREAM_END && this->HasAnotherMember())
    {
      this->Status = inflateReset(&this->Stream);
    }
  }
  return done;
}

void DeflatedStream::Refill()
{
  if (this->Stream.avail_in == 0)
  {
    const std::uint64_t wanted = std::min(Piece, this->Rest);
    this->File.read(
      reinterpret_cast<char*>(this->Packed.data()), static_cast<std::streamsize>(wanted));
    const auto count = static_cast<std::uint64_t>(this->File.gcount());
    this->Rest = count < wanted ? 0 : this->Rest - count;
    this->Stream.next_in = this->Packed.data();
    this->Stream.avail_in = static_cast<uInt>(count);
  }
}

bool DeflatedStream::HasAnotherMember()
{
  this->Refill();
  return this->Stream.avail_in > 0 && *this->Stream.next_in == FirstByteOfGzip;
}

std::optional<std::uint64_t> InflatedSize(
  const std::string& path, std::uint64_t begin, std::uint64_t size)
{
  DeflatedStream stream(path, begin, size);
  std::vector<char> ignored(Piece);
  std::uint64_t total = 0;
  std::uint64_t count = 0;
  do
  {
    count = stream.Read(ignored.data(), Piece);
    total += count;
  } while (count > 0);
  return stream.IsComplete() ? std::optional(total) : std::nullopt;
}
}
