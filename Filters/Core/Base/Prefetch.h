// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Prefetch.h
 * @brief Hints to the processor which memory is needed soon; never changes a result.
 */
#ifndef BoneDecimate_Core_Base_Prefetch_h
#define BoneDecimate_Core_Base_Prefetch_h

namespace bonedecimate
{
inline void Prefetch([[maybe_unused]] const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}
}

#endif
