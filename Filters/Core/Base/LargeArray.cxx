// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LargeArray.h"

#include <algorithm>
#include <memory>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace bonedecimate
{
namespace
{
constexpr std::size_t LargePage = std::size_t(1) << 21U; // bytes
constexpr std::size_t CacheLine = 64;                    // bytes

/// Rounds up to whole large pages if more than half of the last one is needed.
std::size_t SizeToTake(std::size_t bytes)
{
  return std::max(bytes, (bytes + LargePage / 2) / LargePage * LargePage);
}

std::align_val_t AlignmentOf(std::size_t bytes)
{
  return std::align_val_t(SizeToTake(bytes) < LargePage ? CacheLine : LargePage);
}
}

void* AllocateLarge(std::size_t bytes)
{
  void* memory = ::operator new(SizeToTake(bytes), AlignmentOf(bytes));
  RequestLargePages(memory, SizeToTake(bytes));
  return memory;
}

//------------------------------------------------------------------------------
void FreeLarge(void* memory, std::size_t bytes) noexcept
{
  ::operator delete(memory, AlignmentOf(bytes));
}

//------------------------------------------------------------------------------
void RequestLargePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) noexcept
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  void* first = memory;
  if (std::align(LargePage, LargePage, first, bytes) != nullptr)
  {
    madvise(first, bytes / LargePage * LargePage, MADV_HUGEPAGE);
  }
#endif
}
}
