// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeflatedStream.h
 * @brief Compressed voxels, one after the other, and whether they are complete and undamaged, which
 * the libraries of ITK do not check.
 */
#ifndef BoneDecimate_Applications_DeflatedStream_h
#define BoneDecimate_Applications_DeflatedStream_h

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>
#include <zlib.h>

namespace bonedecimate::volume
{
/// A zlib or gzip stream in a file; all members of gzip.
class DeflatedStream
{
public:
  /// @param begin The first byte of the stream in the file.  @param size Its bytes in the file.
  DeflatedStream(const std::string& path, std::uint64_t begin, std::uint64_t size);
  ~DeflatedStream() { inflateEnd(&this->Stream); }
  DeflatedStream(const DeflatedStream&) = delete;
  DeflatedStream& operator=(const DeflatedStream&) = delete;

  /// The next bytes. Returns how many: fewer where the stream ends or is damaged.
  std::uint64_t Read(void* bytes, std::uint64_t count);

  /// Whether all was read and every checksum is right.
  bool IsComplete() const { return this->Status == Z_STREAM_END; }

private:
  void Refill();
  bool HasAnotherMember();

  std::ifstream File;
  std::uint64_t Rest; ///< Bytes of the stream that are not read yet.
  std::vector<Bytef> Packed;
  z_stream Stream{};
  int Status = Z_OK;
};

/**
 * The number of bytes that a zlib or gzip stream in a file holds, all members of gzip together.
 * @param begin The first byte of the stream in the file.  @param size Its bytes in the file.
 * @return Nothing if the stream is truncated or one of its checksums is wrong.
 */
std::optional<std::uint64_t> InflatedSize(
  const std::string& path, std::uint64_t begin, std::uint64_t size);
}

#endif
