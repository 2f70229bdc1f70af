// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BucketLists.h
 * @brief Lists of vertices by the bucket of their cost, eight lists per factor of two. Needs no
 * heap and no comparisons.
 *
 * Vertices are never removed from the middle of a list. The caller checks whether a vertex still
 * belongs to its list.
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_BucketLists_h
#define BoneDecimate_Core_Decimate_Schedule_BucketLists_h

#include "Geometry/Surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace bonedecimate
{
/// The upper 16 bits below the sign bit of a cost: ordered like costs, with 256 buckets per factor
/// of two.
using CostBucket = std::uint16_t;
constexpr CostBucket NeverBucket = 0xFFFF;
/// Last bucket of vertices with an edge to collapse.
constexpr CostBucket LastBucket = NeverBucket - 1;
constexpr int BucketsPerDoubling = 256;
constexpr int BucketsPerList = BucketsPerDoubling / 8;

/// The bucket of a cost of 0 or more; NeverBucket for an infinite one.
inline CostBucket BucketOf(float cost)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &cost, sizeof(bits));
  return cost < std::numeric_limits<float>::infinity() ? static_cast<CostBucket>(bits >> 15U)
                                                       : NeverBucket;
}

/// The bucket `step` buckets higher, but not above the last one.
inline CostBucket Raised(CostBucket bucket, int step)
{
  return static_cast<CostBucket>(std::min<int>(bucket + step, LastBucket));
}

/// The highest cost in the bucket; not finite if there is none.
inline float CostOf(CostBucket bucket)
{
  const std::uint32_t bits = (static_cast<std::uint32_t>(bucket) << 15U) | 0x7FFFU;
  float cost = 0.0F;
  std::memcpy(&cost, &bits, sizeof(cost));
  return cost;
}

/// Number of buckets that are not above the limit. The partial sums are short, so that compilers
/// vectorize the loop.
inline Index CountUpTo(CostBucket limit, const CostBucket* first, const CostBucket* last)
{
  constexpr std::ptrdiff_t maxPart = 4096;
  Index count = 0;
  while (first != last)
  {
    const CostBucket* end = first + std::min(maxPart, last - first);
    std::uint16_t part = 0;
    for (; first != end; ++first)
    {
      part = static_cast<std::uint16_t>(part + (*first <= limit ? 1 : 0));
    }
    count += part;
  }
  return count;
}

class BucketLists
{
public:
  static constexpr int NumberOfLists = (NeverBucket + 1) / BucketsPerList;

  BucketLists()
    : First(NumberOfLists, None)
  {
  }

  void Clear()
  {
    std::fill(this->First.begin(), this->First.end(), None);
    this->Nodes.clear();
    this->Lowest = NumberOfLists;
  }

  void Add(Index vertex, CostBucket bucket)
  {
    const int list = bucket / BucketsPerList;
    this->Nodes.push_back({ vertex, this->First[static_cast<std::size_t>(list)] });
    this->First[static_cast<std::size_t>(list)] = static_cast<Index>(this->Nodes.size() - 1);
    this->Lowest = std::min(this->Lowest, list);
  }

  /// Moves the lowest list to `vertices`, the vertex added last first. Returns the highest bucket
  /// of the list, NeverBucket if there is no list.
  CostBucket TakeLowest(std::vector<Index>& vertices)
  {
    vertices.clear();
    while (
      this->Lowest < NumberOfLists && this->First[static_cast<std::size_t>(this->Lowest)] == None)
    {
      ++this->Lowest;
    }
    if (this->Lowest == NumberOfLists)
    {
      return NeverBucket;
    }
    Index& first = this->First[static_cast<std::size_t>(this->Lowest)];
    for (; first != None; first = this->Nodes[static_cast<std::size_t>(first)].Next)
    {
      vertices.push_back(this->Nodes[static_cast<std::size_t>(first)].Vertex);
    }
    return static_cast<CostBucket>(this->Lowest * BucketsPerList + BucketsPerList - 1);
  }

private:
  struct Node
  {
    Index Vertex;
    Index Next;
  };
  std::vector<Index> First; // node of each list
  std::vector<Node> Nodes;
  int Lowest = NumberOfLists;
};
}

#endif
