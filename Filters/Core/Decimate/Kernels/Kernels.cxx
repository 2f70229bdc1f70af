// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kernels.h"

namespace bonedecimate
{
extern const Kernels PlainKernels;
extern const Kernels BaselineKernels;
#ifdef BONEDECIMATE_X86_KERNELS
extern const Kernels Avx2Kernels;
extern const Kernels Avx512Kernels;
#endif

const std::vector<const Kernels*>& AvailableKernels()
{
  static const std::vector<const Kernels*> available = []
  {
#ifdef BONEDECIMATE_BASELINE_IS_FASTER
    std::vector<const Kernels*> sets = { &PlainKernels, &BaselineKernels };
#else
    std::vector<const Kernels*> sets = { &BaselineKernels, &PlainKernels };
#endif
#ifdef BONEDECIMATE_X86_KERNELS
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq"))
    {
      sets.push_back(&Avx512Kernels);
    }
    if (__builtin_cpu_supports("avx2"))
    {
      sets.push_back(&Avx2Kernels);
    }
#endif
    return sets;
  }();
  return available;
}

namespace
{
const Kernels* Chosen = nullptr;
}

const Kernels& BestKernels()
{
  static const Kernels& best = *AvailableKernels().back();
  return Chosen != nullptr ? *Chosen : best;
}

void ChooseKernels(const Kernels* kernels)
{
  Chosen = kernels;
}
}
