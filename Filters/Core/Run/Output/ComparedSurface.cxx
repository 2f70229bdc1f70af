// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComparedSurface.h"

#include "Mesh/BoneSize.h"
#include "Mesh/Checksum.h"
#include "Mesh/Cleaning.h"
#include "Mesh/Statistics.h"
#include "MissingComponents.h"
#include "Proof/Guard/IntersectingPairs.h"

namespace bonedecimate
{
namespace
{
/// None after an abort, and of a surface that cannot be used.
std::optional<ComparedFigures> DescribeCompared(
  const Surface& surface, const CleanSurface& cleaned, int threads, const Monitor& monitor)
{
  if (cleaned.Status != InputStatus::Good)
  {
    return std::nullopt;
  }
  const std::optional<std::int64_t> pairs =
    CountIntersectingPairs(cleaned.Surface, threads, monitor);
  return pairs ? std::optional<ComparedFigures>({ Describe(cleaned.Surface, threads), *pairs,
                   DiagonalOf(cleaned.Surface.Points), TriangleChecksum(surface, threads) })
               : std::nullopt;
}
}

void DescribePair(const Surface& reference, const Surface& result, int threads,
  const Monitor& monitor, Certificate& certificate, PairFigures& figures)
{
  if (certificate.Status != CertificateStatus::Good)
  {
    return;
  }
  const CleanSurface before = Clean(reference, true, threads);
  const CleanSurface after = Clean(result, true, threads);
  figures.Reference = DescribeCompared(reference, before, threads, PartOf(monitor, 0.0, 0.45));
  figures.Result = DescribeCompared(result, after, threads, PartOf(monitor, 0.45, 0.9));
  if (figures.Reference && figures.Result)
  {
    figures.Missing = FindMissing(
      before.Surface, after.Surface, after.Origin - before.Origin, before.Origin, threads);
  }
  if (monitor && !monitor(1.0))
  {
    certificate.Status = CertificateStatus::Aborted;
  }
}
}
