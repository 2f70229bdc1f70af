// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checksum.h"

#include "Parallel.h"

#include <cstring>

namespace bonedecimate
{
namespace
{
constexpr std::uint64_t Start = 14695981039346656037ULL;
constexpr std::uint64_t Factor = 1099511628211ULL;
using Sums = std::array<std::uint64_t, 3>;

std::uint64_t Word(double value)
{
  std::uint64_t word = 0;
  std::memcpy(&word, &value, sizeof(word));
  return word;
}

std::uint64_t Word(Index value)
{
  return static_cast<std::uint64_t>(value);
}

/// The sums of every block of points or triangles.
template <typename Triple>
std::vector<Sums> SumsOfBlocks(const std::vector<Triple>& triples, int threads)
{
  std::vector<Sums> sums(NumberOfBlocks(triples.size()));
  ForEachBlock(triples.size(), threads,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      Sums sum = { Start, Start, Start };
      for (std::size_t i = first; i < last; ++i)
      {
        sum[0] = (sum[0] ^ Word(triples[i][0])) * Factor;
        sum[1] = (sum[1] ^ Word(triples[i][1])) * Factor;
        sum[2] = (sum[2] ^ Word(triples[i][2])) * Factor;
      }
      sums[block] = sum;
    });
  return sums;
}
}

std::uint64_t Checksum(const Surface& surface, int threads)
{
  std::uint64_t checksum = (Start ^ surface.Points.size()) * Factor;
  const auto add = [&](const std::vector<Sums>& blocks)
  {
    for (const Sums& sums : blocks)
    {
      for (const std::uint64_t sum : sums)
      {
        checksum = (checksum ^ sum) * Factor;
      }
    }
  };
  add(SumsOfBlocks(surface.Points, threads));
  add(SumsOfBlocks(surface.Triangles, threads));
  return checksum;
}
}
