// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel.h"

#ifdef __linux__
#include <sched.h>
#endif

namespace bonedecimate
{
unsigned int NumberOfProcessors()
{
#ifdef __linux__
  cpu_set_t processors;
  CPU_ZERO(&processors);
  if (sched_getaffinity(0, sizeof(processors), &processors) == 0)
  {
    return std::max(1U, static_cast<unsigned int>(CPU_COUNT(&processors)));
  }
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}
}
