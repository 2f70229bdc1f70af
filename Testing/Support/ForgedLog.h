// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ForgedLog.h
 * @brief A log of levels with the checksum of its bytes, as Filters/Core/Levels/README.md says, so
 * that readers reach the invalid content before it.
 */
#ifndef BoneDecimate_Testing_ForgedLog_h
#define BoneDecimate_Testing_ForgedLog_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bonedecimate::testsupport
{
/// Replaces the last eight bytes, if there are as many, by the checksum.
inline std::vector<unsigned char> Forged(std::vector<unsigned char> bytes)
{
  if (bytes.size() < 8)
  {
    return bytes;
  }
  const std::size_t size = bytes.size() - 8;
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (std::size_t at = 0; at < size; at += 8)
  {
    std::array<unsigned char, 8> word = {};
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at),
      std::min<std::size_t>(8, size - at), word.begin());
    std::uint64_t value = 0;
    std::for_each(
      word.rbegin(), word.rend(), [&](unsigned char byte) { value = value * 256 + byte; });
    sum = (sum ^ value) * 0x100000001b3ULL;
  }
  for (std::size_t k = 0; k < 8; ++k)
  {
    bytes[size + k] = static_cast<unsigned char>(sum >> (8 * k));
  }
  return bytes;
}

/// The least byte first.
inline void PutIndex(std::vector<unsigned char>& bytes, std::size_t at, std::uint32_t value)
{
  for (std::size_t k = 0; k < 4; ++k)
  {
    bytes[at + k] = static_cast<unsigned char>(value >> (8 * k));
  }
}
}

#endif
