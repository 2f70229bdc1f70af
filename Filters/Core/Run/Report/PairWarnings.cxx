// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PairWarnings.h"

#include "SizeText.h"

#include <cstdio>

namespace bonedecimate
{
namespace
{
std::string MissingSentence(const PairFigures& pair)
{
  const MissingComponent& largest = pair.Missing.front();
  const std::size_t count = pair.Missing.size();
  char where[160];
  std::snprintf(where, sizeof(where), "%lld triangles, %.3g mm, at (%.6g, %.6g, %.6g)",
    static_cast<long long>(largest.Triangles), largest.Diagonal, largest.Center[0],
    largest.Center[1], largest.Center[2]);
  return std::to_string(count) + " of " + std::to_string(pair.Reference->Surface.Components) +
    (count == 1 ? " components of the reference is" : " components of the reference are") +
    " missing in the result: " + (count == 1 ? "" : "the largest has ") + where;
}

bool IsInsideOut(const SurfaceStatistics& before, const SurfaceStatistics& after)
{
  return before.BoundaryEdges == 0 && after.BoundaryEdges == 0 &&
    before.Volume * after.Volume < 0.0;
}

/// "the result has 2 non-manifold edges, the reference 0"
std::string MoreSentence(
  std::int64_t before, std::int64_t after, const std::string& one, const std::string& more)
{
  return "the result has " + std::to_string(after) + (after == 1 ? one : more) +
    ", the reference " + std::to_string(before);
}
}

std::vector<std::string> PairWarnings(const PairFigures& pair)
{
  std::vector<std::string> warnings;
  if (!pair.Reference || !pair.Result)
  {
    return warnings;
  }
  const ComparedFigures& before = *pair.Reference;
  const ComparedFigures& after = *pair.Result;
  if (before.Checksum == after.Checksum)
  {
    warnings.emplace_back("the reference and the result have the same triangles");
  }
  if (!pair.Missing.empty())
  {
    warnings.push_back(MissingSentence(pair));
  }
  if (IsInsideOut(before.Surface, after.Surface))
  {
    warnings.emplace_back(before.Surface.Volume < 0.0
        ? "the reference is inside out, compared with the result"
        : "the result is inside out, compared with the reference");
  }
  if (after.Surface.NonManifoldEdges > before.Surface.NonManifoldEdges)
  {
    warnings.push_back(MoreSentence(before.Surface.NonManifoldEdges, after.Surface.NonManifoldEdges,
      " non-manifold edge", " non-manifold edges"));
  }
  if (after.IntersectingPairs > before.IntersectingPairs)
  {
    warnings.push_back(MoreSentence(before.IntersectingPairs, after.IntersectingPairs,
      " intersecting pair of triangles", " intersecting pairs of triangles"));
  }
  return warnings;
}

//------------------------------------------------------------------------------
std::vector<std::string> PairWarnings(
  const Surface& reference, const Surface& result, double tolerance, const PairFigures& pair)
{
  std::vector<std::string> warnings = PairSizeWarnings(reference, result, tolerance);
  const std::vector<std::string> more = PairWarnings(pair);
  warnings.insert(warnings.end(), more.begin(), more.end());
  return warnings;
}
}
