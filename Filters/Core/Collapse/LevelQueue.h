// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelQueue.h
 * @brief Vertices sorted by the level of their cost, eight levels an octave: no heap, no comparison.
 *
 * Within a level the order is first in, first out. An entry is forgotten when its vertex is set to another level.
 */
#ifndef BoneDecimate_Core_Collapse_LevelQueue_h
#define BoneDecimate_Core_Collapse_LevelQueue_h

#include "Surface.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace bonedecimate
{
class LevelQueue
{
public:
  using Level = std::int32_t;
  static constexpr Level LevelsOfOctave = 8;
  static constexpr Level NumberOfLevels = 2048; // exponents of float times eight
  static constexpr Level NoLevel = -1;

  explicit LevelQueue(Index numberOfVertices)
    : Levels(static_cast<std::size_t>(numberOfVertices), NoLevel)
    , Waiting(NumberOfLevels)
    , Read(NumberOfLevels, 0)
  {
  }

  /// Level of a cost of 0 or more: the exponent and three bits of the fraction of a float.
  static Level LevelOf(double cost)
  {
    const float value = static_cast<float>(cost);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    return std::min(static_cast<Level>(bits >> 20), NumberOfLevels - 1);
  }

  /// Puts the vertex on a level; beyond the last one it is out of the queue.
  void Set(Index vertex, Level level)
  {
    this->Levels[vertex] = level < NumberOfLevels ? level : NoLevel;
    if (level < NumberOfLevels)
    {
      this->Waiting[static_cast<std::size_t>(level)].push_back(vertex);
      this->Lowest = std::min(this->Lowest, level);
    }
  }
  void Remove(Index vertex) { this->Levels[vertex] = NoLevel; }

  struct Entry
  {
    Index Vertex;
    Level At;
  };
  /// Takes out the first vertex of the lowest level; Vertex is None when there is none.
  Entry Pop()
  {
    for (; this->Lowest < NumberOfLevels; ++this->Lowest)
    {
      std::vector<Index>& waiting = this->Waiting[static_cast<std::size_t>(this->Lowest)];
      std::size_t& read = this->Read[static_cast<std::size_t>(this->Lowest)];
      while (read < waiting.size())
      {
        const Index vertex = waiting[read++];
        if (this->Levels[vertex] == this->Lowest)
        {
          this->Levels[vertex] = NoLevel;
          return { vertex, this->Lowest };
        }
      }
      waiting.clear();
      read = 0;
    }
    return { None, NoLevel };
  }

private:
  std::vector<Level> Levels;
  std::vector<std::vector<Index>> Waiting;
  std::vector<std::size_t> Read;
  Level Lowest = NumberOfLevels;
};
}

#endif
