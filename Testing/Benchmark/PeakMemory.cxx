// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeakMemory.h"

#include <fstream>
#include <sstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{
/// A line of /proc/self/status such as "VmHWM:  1234 kB"; 0 where there is none.
std::int64_t StatusBytes(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
  {
    std::istringstream words(line);
    std::string word;
    std::int64_t kilobytes = 0;
    if (words >> word >> kilobytes && word == name)
    {
      return 1024 * kilobytes;
    }
  }
  return 0;
}
}

std::int64_t memory::Held()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  return StatusBytes("VmRSS:");
}

void memory::ForgetPeak()
{
  std::ofstream("/proc/self/clear_refs") << 5;
}

std::int64_t memory::Peak()
{
  return StatusBytes("VmHWM:");
}
