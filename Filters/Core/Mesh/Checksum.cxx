// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checksum.h"

#include "Base/Parallel.h"
#include "SplitMix.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <numeric>

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

/// Sums of every block of points or triangles.
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

std::uint64_t HashOf(const Surface& surface, const Triangle& corners)
{
  std::array<std::array<double, 3>, 3> positions{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3& p = surface.Points[corners[k]];
    positions[k] = { p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 }; // -0 becomes 0
  }
  std::rotate(
    positions.begin(), std::min_element(positions.begin(), positions.end()), positions.end());
  std::uint64_t hash = Start;
  for (const std::array<double, 3>& position : positions)
  {
    for (const double coordinate : position)
    {
      hash = SplitMix(hash + Word(coordinate));
    }
  }
  return hash;
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

std::uint64_t TriangleChecksum(const Surface& surface, int threads)
{
  const std::size_t count = surface.Triangles.size();
  std::vector<std::uint64_t> sums(NumberOfBlocks(count));
  ForEachBlock(count, threads,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t t = first; t < last; ++t)
      {
        sums[block] += HashOf(surface, surface.Triangles[t]);
      }
    });
  return std::accumulate(sums.begin(), sums.end(), std::uint64_t{ 0 });
}

std::string TriangleChecksumText(std::uint64_t checksum)
{
  char text[32];
  std::snprintf(text, sizeof(text), "triangles:%016llx", static_cast<unsigned long long>(checksum));
  return text;
}
}
