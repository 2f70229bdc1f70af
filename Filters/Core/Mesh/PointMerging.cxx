// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointMerging.h"

#include "Base/LargeArray.h"
#include "Base/Parallel.h"

#include <cstring>
#include <numeric>

namespace bonedecimate
{
namespace
{
constexpr std::size_t PointsOfPart = 4096;
constexpr std::size_t MaxParts = 1024;

/// Adds zero because -0 and +0 are equal and need equal hashes.
std::uint32_t HashOf(const Vector3& p)
{
  constexpr std::uint64_t factors[3] = { 0x9e3779b97f4a7c15ULL, 0xc2b2ae3d27d4eb4fULL,
    0x165667b19e3779f9ULL };
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double coordinate = p[static_cast<Eigen::Index>(i)] + 0.0;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    hash += (bits ^ bits >> 32) * factors[i];
  }
  hash = (hash ^ hash >> 29) * factors[0];
  return static_cast<std::uint32_t>(hash >> 32);
}

struct Entry
{
  std::uint32_t Hash;
  Index Point;
};

/// The points sorted by the first bits of their hashes, ascending in each part.
struct Parts
{
  LargeArray<Entry> Entries;
  std::vector<std::size_t> Starts; // for each part, and finally the end
};

std::size_t NumberOfParts(std::size_t points)
{
  std::size_t parts = 1;
  while (parts < MaxParts && parts * PointsOfPart < points)
  {
    parts *= 2;
  }
  return parts;
}

/// Converts the counts of all blocks and parts to offsets, parts first.
std::vector<std::size_t> OffsetBlocks(
  std::vector<std::size_t>& counts, std::size_t blocks, std::size_t parts)
{
  std::vector<std::size_t> starts(parts + 1, 0);
  std::size_t sum = 0;
  for (std::size_t part = 0; part < parts; ++part)
  {
    starts[part] = sum;
    for (std::size_t block = 0; block < blocks; ++block)
    {
      const std::size_t count = counts[block * parts + part];
      counts[block * parts + part] = sum;
      sum += count;
    }
  }
  starts[parts] = sum;
  return starts;
}

Parts Distribute(
  const std::vector<Vector3>& points, const LargeArray<Index>& representative, int threads)
{
  const std::size_t parts = NumberOfParts(points.size());
  const std::size_t blocks = NumberOfBlocks(points.size());
  const auto partOf = [=](std::uint32_t hash) { return std::uint64_t(hash) * parts >> 32; };
  LargeArray<std::uint32_t> hashes(points.size());
  std::vector<std::size_t> offsets(blocks * parts, 0);
  ForEachBlock(points.size(), threads,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t p = first; p < last; ++p)
      {
        hashes[p] = HashOf(points[p]);
        offsets[block * parts + partOf(hashes[p])] += representative[p] != None ? 1 : 0;
      }
    });
  Parts result;
  result.Starts = OffsetBlocks(offsets, blocks, parts);
  result.Entries.resize(result.Starts.back());
  ForEachBlock(points.size(), threads,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t p = first; p < last; ++p)
      {
        if (representative[p] != None)
        {
          result.Entries[offsets[block * parts + partOf(hashes[p])]++] = { hashes[p],
            static_cast<Index>(p) };
        }
      }
    });
  return result;
}

/// A table with open addressing, at most half full. The slot comes from the last bits of the hash.
std::int64_t MergePart(const std::vector<Vector3>& points, const Entry* first, const Entry* last,
  std::vector<Entry>& table, LargeArray<Index>& representative)
{
  std::size_t size = 16;
  while (size < 2 * static_cast<std::size_t>(last - first))
  {
    size *= 2;
  }
  table.assign(size, { 0, None });
  std::int64_t merged = 0;
  for (const Entry* entry = first; entry != last; ++entry)
  {
    std::size_t slot = entry->Hash & (size - 1);
    while (table[slot].Point != None &&
      (table[slot].Hash != entry->Hash || points[table[slot].Point] != points[entry->Point]))
    {
      slot = (slot + 1) & (size - 1);
    }
    if (table[slot].Point == None)
    {
      table[slot] = *entry;
    }
    if (table[slot].Point != entry->Point)
    {
      representative[entry->Point] = table[slot].Point;
      ++merged;
    }
  }
  return merged;
}
}

std::int64_t MergeEqualPoints(
  const std::vector<Vector3>& points, LargeArray<Index>& representative, int threads)
{
  const Parts parts = Distribute(points, representative, threads);
  std::vector<std::int64_t> merged(parts.Starts.size() - 1, 0);
  ForEachPart(merged.size(), threads, Monitor(),
    [&](std::size_t part)
    {
      std::vector<Entry> table;
      merged[part] = MergePart(points, parts.Entries.data() + parts.Starts[part],
        parts.Entries.data() + parts.Starts[part + 1], table, representative);
    });
  return std::accumulate(merged.begin(), merged.end(), std::int64_t(0));
}
}
