// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeakMemory.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{
/// A line of /proc/self/status such as "VmHWM:  1234 kB", in megabytes; 0 where there is none.
double StatusMegabytes(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
  {
    std::istringstream words(line);
    std::string word;
    double kilobytes = 0.0;
    if (words >> word >> kilobytes && word == name)
    {
      return kilobytes / 1024.0;
    }
  }
  return 0.0;
}
}

PeakMemory::PeakMemory()
{
#ifdef __GLIBC__
  malloc_trim(0); // what an earlier run freed would be reused unseen
#endif
  std::ofstream("/proc/self/clear_refs") << 5; // sets the high-water mark back to what is held now
  this->AtFirst = StatusMegabytes("VmRSS:");
}

double PeakMemory::Megabytes() const
{
  return std::max(0.0, StatusMegabytes("VmHWM:") - this->AtFirst);
}
