// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelLists.h
 * @brief Vertices listed by the level of their cost, eight levels an octave: no heap, no comparison.
 *
 * Nothing is ever taken out of the middle: whoever takes a vertex checks whether it still belongs to that level.
 */
#ifndef BoneDecimate_Core_Collapse_LevelLists_h
#define BoneDecimate_Core_Collapse_LevelLists_h

#include "Surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace bonedecimate
{
/// The upper 16 bits below the sign of a cost: ordered like costs, 256 to an octave.
using CostKey = std::uint16_t;
constexpr CostKey NeverKey = 0xFFFF;
constexpr int KeysOfOctave = 256;
constexpr int KeysOfLevel = KeysOfOctave / 8;

/// Of a cost of 0 or more; infinite ones never come up.
inline CostKey KeyOf(float cost)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &cost, sizeof(bits));
  return cost < std::numeric_limits<float>::infinity() ? static_cast<CostKey>(bits >> 15U)
                                                       : NeverKey;
}

/// The highest cost of the key; not finite if no cost has it.
inline float CostOf(CostKey key)
{
  const std::uint32_t bits = (static_cast<std::uint32_t>(key) << 15U) | 0x7FFFU;
  float cost = 0.0F;
  std::memcpy(&cost, &bits, sizeof(cost));
  return cost;
}

/// How many of the keys are not above the limit; short sums, so that compilers count many at a time.
inline Index CountUpTo(CostKey limit, const CostKey* first, const CostKey* last)
{
  constexpr std::ptrdiff_t most = 4096;
  Index count = 0;
  while (first != last)
  {
    const CostKey* end = first + std::min(most, last - first);
    std::uint16_t part = 0;
    for (; first != end; ++first)
    {
      part = static_cast<std::uint16_t>(part + (*first <= limit ? 1 : 0));
    }
    count += part;
  }
  return count;
}

class LevelLists
{
public:
  static constexpr int NumberOfLevels = (NeverKey + 1) / KeysOfLevel;

  LevelLists()
    : First(NumberOfLevels, None)
  {
  }

  void Clear()
  {
    std::fill(this->First.begin(), this->First.end(), None);
    this->Nodes.clear();
    this->Lowest = NumberOfLevels;
  }

  void Add(Index vertex, CostKey key)
  {
    const int level = key / KeysOfLevel;
    this->Nodes.push_back({ vertex, this->First[static_cast<std::size_t>(level)] });
    this->First[static_cast<std::size_t>(level)] = static_cast<Index>(this->Nodes.size() - 1);
    this->Lowest = std::min(this->Lowest, level);
  }

  /// Moves the lowest list there is to `vertices`, the last one added first; returns its highest key, NeverKey if there
  /// is none.
  CostKey TakeLowest(std::vector<Index>& vertices)
  {
    vertices.clear();
    while (
      this->Lowest < NumberOfLevels && this->First[static_cast<std::size_t>(this->Lowest)] == None)
    {
      ++this->Lowest;
    }
    if (this->Lowest == NumberOfLevels)
    {
      return NeverKey;
    }
    Index& first = this->First[static_cast<std::size_t>(this->Lowest)];
    for (; first != None; first = this->Nodes[static_cast<std::size_t>(first)].Next)
    {
      vertices.push_back(this->Nodes[static_cast<std::size_t>(first)].Vertex);
    }
    return static_cast<CostKey>(this->Lowest * KeysOfLevel + KeysOfLevel - 1);
  }

private:
  struct Node
  {
    Index Vertex;
    Index Next;
  };
  std::vector<Index> First; // of each level
  std::vector<Node> Nodes;
  int Lowest = NumberOfLevels;
};
}

#endif
