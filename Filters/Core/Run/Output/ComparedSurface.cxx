// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComparedSurface.h"

#include "Mesh/Cleaning.h"
#include "Mesh/Statistics.h"
#include "Proof/Guard/IntersectingPairs.h"

namespace bonedecimate
{
std::optional<ComparedFigures> DescribeCompared(
  const Surface& surface, int threads, const Monitor& monitor)
{
  const CleanSurface cleaned = Clean(surface, true, threads);
  if (cleaned.Status != InputStatus::Good)
  {
    return std::nullopt;
  }
  const std::optional<std::int64_t> pairs =
    CountIntersectingPairs(cleaned.Surface, threads, monitor);
  return pairs ? std::optional<ComparedFigures>({ Describe(cleaned.Surface, threads), *pairs })
               : std::nullopt;
}
}
