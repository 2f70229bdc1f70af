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

//------------------------------------------------------------------------------
void DescribePair(const Surface& reference, const Surface& result, int threads,
  const Monitor& monitor, Certificate& certificate, PairFigures& figures)
{
  if (certificate.Status != CertificateStatus::Good)
  {
    return;
  }
  figures.Reference = DescribeCompared(reference, threads, PartOf(monitor, 0.0, 0.5));
  figures.Result = DescribeCompared(result, threads, PartOf(monitor, 0.5, 1.0));
  if (monitor && !monitor(1.0))
  {
    certificate.Status = CertificateStatus::Aborted;
  }
}
}
