// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleBounds.h"

#include "Base/Parallel.h"

#include <limits>

namespace bonedecimate::certificate
{
namespace
{
constexpr std::int64_t MaxCutsOfOne = 4096;
}

std::vector<double> FindTriangleBounds(const Simplices& source, const Target& target,
  const PointValues& values, const SearchGoal& goal, MaxExcess& max, const Monitor& monitor)
{
  std::vector<double> bounds(source.Size(), std::numeric_limits<double>::infinity());
  std::vector<MaxExcess> parts(NumberOfChunks(source.Size()));
  ForEachChunk(source.Size(), goal.NumberOfThreads, monitor,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      PieceSearch search(source, target, values, goal, MaxExcess());
      for (std::size_t simplex = first; simplex < last; ++simplex)
      {
        bounds[simplex] = search.UpperOf(static_cast<Index>(simplex), MaxCutsOfOne);
        parts[chunk].Join(search.Max());
      }
    });
  for (const MaxExcess& part : parts)
  {
    max.Join(part);
  }
  return bounds;
}
}
