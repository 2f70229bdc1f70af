// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MemoryCap.h
 * @brief A limit for libraries that allocate what a file announces.
 */
#ifndef BoneDecimate_Applications_MemoryCap_h
#define BoneDecimate_Applications_MemoryCap_h

#include <cstdint>

namespace bonedecimate::volume
{
/// 20 times the size of the files, and at least 1 GB.
std::uint64_t MemoryForFiles(std::uint64_t bytes);

/// As long as it lives, allocations beyond what the process has now and that many bytes throw
/// std::bad_alloc. Without effect on systems that do not tell what a process has.
class MemoryCap
{
public:
  explicit MemoryCap(std::uint64_t bytes);
  ~MemoryCap();
  MemoryCap(const MemoryCap&) = delete;
  MemoryCap& operator=(const MemoryCap&) = delete;

private:
  std::uint64_t Before = 0; ///< The limit; 0: it was not changed.
};
}

#endif
