// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WordBasis.h
 * @brief A basis of 64-bit words: none is the exclusive or of others.
 */
#ifndef BoneDecimate_Core_Repair_Tunnels_WordBasis_h
#define BoneDecimate_Core_Repair_Tunnels_WordBasis_h

#include <array>
#include <cstdint>

namespace bonedecimate
{
class WordBasis
{
public:
  bool IsIndependent(std::uint64_t word) const { return this->Reduce(word) != 0; }

  /// @return Whether the word was independent.
  bool Add(std::uint64_t word)
  {
    const std::uint64_t rest = this->Reduce(word);
    for (std::size_t bit = 64; rest != 0 && bit-- > 0;)
    {
      if ((rest >> bit & 1U) != 0)
      {
        this->ByHighestBit[bit] = rest;
        return true;
      }
    }
    return false;
  }

private:
  /// The exclusive or of the word and those words of the basis that clear all of its highest bits;
  /// 0 if it depends on them.
  std::uint64_t Reduce(std::uint64_t word) const
  {
    for (std::size_t bit = 64; bit-- > 0;)
    {
      if ((word >> bit & 1U) != 0)
      {
        word ^= this->ByHighestBit[bit];
      }
    }
    return word;
  }

  std::array<std::uint64_t, 64> ByHighestBit{}; // 0: none
};
}

#endif
