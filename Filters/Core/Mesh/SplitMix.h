// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SplitMix.h
 * @brief Mixes all bits of a word, for sums that do not depend on the order of their terms.
 *
 * The mixer of SplitMix64: G. Steele, D. Lea, C. Flood, Fast splittable pseudorandom number
 * generators, 2014.
 */
#ifndef BoneDecimate_Core_Mesh_SplitMix_h
#define BoneDecimate_Core_Mesh_SplitMix_h

#include <cstdint>

namespace bonedecimate
{
inline std::uint64_t SplitMix(std::uint64_t number)
{
  number += 0x9e3779b97f4a7c15ULL;
  number = (number ^ (number >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  number = (number ^ (number >> 27U)) * 0x94d049bb133111ebULL;
  return number ^ (number >> 31U);
}
}

#endif
