// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryCap.h"

#include <algorithm>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace bonedecimate::volume
{
namespace
{
/// Size of the address space of this process; 0 if it is not known.
std::uint64_t BytesOfProcess()
{
  std::ifstream file("/proc/self/statm");
  std::uint64_t pages = 0;
  file >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}
}

std::uint64_t MemoryForFiles(std::uint64_t bytes)
{
  constexpr std::uint64_t least = std::uint64_t(1) << 30;
  return std::max(least, 20 * bytes);
}

MemoryCap::MemoryCap(std::uint64_t bytes)
{
  rlimit limit{};
  const std::uint64_t now = BytesOfProcess();
  if (now == 0 || getrlimit(RLIMIT_AS, &limit) != 0)
  {
    return;
  }
  this->Before = limit.rlim_cur;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, now + bytes);
  setrlimit(RLIMIT_AS, &limit);
}

MemoryCap::~MemoryCap()
{
  rlimit limit{};
  if (this->Before != 0 && getrlimit(RLIMIT_AS, &limit) == 0)
  {
    limit.rlim_cur = this->Before;
    setrlimit(RLIMIT_AS, &limit);
  }
}
}
