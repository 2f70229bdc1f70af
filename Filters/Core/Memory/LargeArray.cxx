// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LargeArray.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace bonedecimate
{
namespace
{
constexpr std::size_t SizeOfLargePage = std::size_t(1) << 21U; // bytes
constexpr std::size_t SizeOfLine = 64;                         // bytes, of the processor's cache

std::align_val_t AlignmentOf(std::size_t bytes)
{
  return std::align_val_t(bytes >= SizeOfLargePage ? SizeOfLargePage : SizeOfLine);
}
}

void* AllocateLarge(std::size_t bytes)
{
  void* memory = ::operator new(bytes, AlignmentOf(bytes));
#if defined(__linux__)
  if (bytes >= SizeOfLargePage)
  {
    // Only a wish, and only for pages that are used whole, so that no memory is wasted.
    madvise(memory, bytes / SizeOfLargePage * SizeOfLargePage, MADV_HUGEPAGE);
  }
#endif
  return memory;
}

//------------------------------------------------------------------------------
void FreeLarge(void* memory, std::size_t bytes) noexcept
{
  ::operator delete(memory, AlignmentOf(bytes));
}
}
