// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleBounds.h"

#include "Parallel.h"
#include "PieceSearch.h"

#include <algorithm>

namespace bonedecimate::certificate
{
namespace
{
constexpr std::int64_t MostCutsOfOne = 4096;
}

std::vector<double> FindTriangleBounds(const Simplices& source, const Target& target,
  const PointValues& values, const SearchGoal& goal, double most, const Monitor& monitor)
{
  std::vector<double> bounds(source.Size(), most);
  ForEachChunk(source.Size(), goal.NumberOfThreads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      PieceSearch search(source, target, values, goal, LargestExcess());
      for (std::size_t simplex = first; simplex < last; ++simplex)
      {
        bounds[simplex] =
          std::min(most, search.UpperOf(static_cast<Index>(simplex), MostCutsOfOne));
      }
    });
  return bounds;
}
}
