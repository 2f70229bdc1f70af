// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeflatedStream.h
 * @brief Whether compressed voxels are complete and undamaged, which the libraries of ITK do not check.
 */
#ifndef BoneDecimate_Applications_DeflatedStream_h
#define BoneDecimate_Applications_DeflatedStream_h

#include <cstdint>
#include <optional>
#include <string>

namespace bonedecimate::volume
{
/**
 * The number of bytes that a zlib or gzip stream in a file holds, all members of gzip together.
 * @param begin The first byte of the stream in the file.  @param size Its bytes in the file.
 * @return Nothing if the stream is truncated or one of its checksums is wrong.
 */
std::optional<std::uint64_t> InflatedSize(
  const std::string& path, std::uint64_t begin, std::uint64_t size);
}

#endif
