// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComparedSurface.h"

#include "Geometry/TriangleGeometry.h"
#include "ListLeftOut.h"
#include "Mesh/BoneSize.h"
#include "Mesh/Checksum.h"
#include "Mesh/Cleaning.h"
#include "Mesh/Statistics.h"
#include "MissingComponents.h"
#include "Proof/Guard/IntersectingPairs.h"
#include "Run/Input/ReferenceInput.h"

#include <algorithm>

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

/// The part of a surface that is compared: all triangles but those without area that cleaning
/// drops.
class ComparedPart
{
public:
  ComparedPart(const ComparedSurface& whole, int threads)
    : Whole(whole.Surface)
    , LeftOut(whole.LeftOut)
  {
    const std::vector<Triangle>& triangles = this->Whole.Triangles;
    const auto isFlat = [this](const Triangle& c) { return this->IsFlat(c); };
    if (std::none_of(triangles.begin(), triangles.end(), isFlat))
    {
      return;
    }
    CleanSurface cleaned = Clean(this->Whole, true, threads);
    if (cleaned.Status != InputStatus::Good && cleaned.Status != InputStatus::NoTriangles)
    {
      return; // the certificate says what is wrong
    }
    this->Kept = KeptPart(this->Whole, cleaned);
    this->OriginalTriangle = std::move(cleaned.InputTriangle);
    std::sort(this->OriginalTriangle.begin(), this->OriginalTriangle.end());
    const std::vector<Triangle>& dropped = this->Kept->LeftOut;
    if (!dropped.empty())
    {
      this->LeftOut.push_back(TrianglesWithoutArea(static_cast<std::int64_t>(dropped.size()), -1,
        ShapesOf(this->Whole.Points, dropped, true)));
    }
  }

  const Surface& Get() const { return this->Kept ? this->Kept->Surface : this->Whole; }
  const std::vector<LeftOutShape>& GetLeftOut() const { return this->LeftOut; }

  /// Turns the number of a triangle into that in the whole surface.
  void Restore(Index& triangle) const
  {
    triangle = this->Kept && triangle != None
      ? this->OriginalTriangle[static_cast<std::size_t>(triangle)]
      : triangle;
  }

private:
  bool IsFlat(const Triangle& c) const
  {
    const auto isThere = [this](Index corner)
    { return corner >= 0 && static_cast<std::size_t>(corner) < this->Whole.Points.size(); };
    const std::vector<Vector3>& p = this->Whole.Points;
    return std::all_of(c.begin(), c.end(), isThere) &&
      AreaVector(p[c[0]], p[c[1]], p[c[2]]).isZero(0.0);
  }

  const Surface& Whole;
  std::vector<LeftOutShape> LeftOut;
  std::optional<KeptSurface> Kept; // nothing: the whole surface
  std::vector<Index> OriginalTriangle;
};

void RestoreTriangles(
  const ComparedPart& from, const ComparedPart& to, DirectedCertificate& directed)
{
  for (DistanceBounds* bounds : { &directed.Distance, &directed.Excess })
  {
    from.Restore(bounds->Triangle);
    to.Restore(bounds->NearestTriangle);
  }
}

/// Says in the certificate if that was aborted.
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

//------------------------------------------------------------------------------
Certificate CertifyPair(const ComparedSurface& reference, const ComparedSurface& result,
  const CertificateOptions& options, bool withFigures, const Monitor& monitor, PairFigures& figures)
{
  const int threads = options.NumberOfThreads;
  const ComparedPart one(reference, threads), two(result, threads);
  const double certified = withFigures ? 0.8 : 1.0;
  const Monitor whole = monitor ? monitor : [](double) { return true; };
  Certificate found = Certify(one.Get(), two.Get(), options, PartOf(whole, 0.0, certified));
  RestoreTriangles(one, two, found.ReferenceToResult);
  RestoreTriangles(two, one, found.ResultToReference);
  RestoreTriangles(one, two, found.BoundaryOfReferenceToResult);
  RestoreTriangles(two, one, found.BoundaryOfResultToReference);
  figures.LeftOut =
    LeftOutOfPair(one.GetLeftOut(), one.Get(), two.GetLeftOut(), two.Get(), threads);
  if (withFigures)
  {
    DescribePair(
      reference.Surface, result.Surface, threads, PartOf(whole, certified, 1.0), found, figures);
  }
  return found;
}
}
