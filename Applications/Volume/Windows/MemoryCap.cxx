// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryCap.h"

#include <algorithm>

namespace bonedecimate::volume
{
std::uint64_t MemoryForFiles(std::uint64_t bytes)
{
  constexpr std::uint64_t least = std::uint64_t(1) << 30;
  return std::max(least, 20 * bytes);
}

MemoryCap::MemoryCap(std::uint64_t) {}

MemoryCap::~MemoryCap() = default;
}
