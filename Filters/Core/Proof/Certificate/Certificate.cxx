// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certificate.h"

#include "EdgeSides.h"
#include "Foot.h"
#include "Frame.h"
#include "PairCertificate.h"
#include "Stages.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace certificate
{
namespace
{

CertificateStatus Check(
  const Surface& reference, const Surface& result, const CertificateOptions& options)
{
  if (reference.Triangles.empty() || result.Triangles.empty())
  {
    return reference.Triangles.empty() ? CertificateStatus::EmptyReference
                                       : CertificateStatus::EmptyResult;
  }
  if (!HasUsableTriangles(reference) || !HasUsableTriangles(result))
  {
    return HasUsableTriangles(reference) ? CertificateStatus::BadResult
                                         : CertificateStatus::BadReference;
  }
  const auto isGood = [](double tolerance) { return !(tolerance > MaxCoordinate); };
  const std::vector<double>& map = options.ToleranceMap;
  const bool goodMap = (map.empty() || map.size() == reference.Points.size()) &&
    std::all_of(map.begin(), map.end(), isGood);
  const bool goodTolerance =
    !options.Tolerance || (*options.Tolerance >= 0.0 && isGood(*options.Tolerance));
  return goodMap && goodTolerance ? CertificateStatus::Good : CertificateStatus::BadTolerance;
}

/// Options without tolerances that no distance of two points can reach: rounding grows with them.
CertificateOptions WithinReach(CertificateOptions options, const Frame& frame)
{
  const double farthest = 4.0 * frame.Extent; // mm, more than the diagonal of the box around both
  const auto limit = [farthest](double tolerance) { return std::min(tolerance, farthest); };
  std::vector<double>& map = options.ToleranceMap;
  std::transform(map.begin(), map.end(), map.begin(),
    [limit](double tolerance) { return tolerance >= 0.0 ? limit(tolerance) : tolerance; });
  options.Tolerance = options.Tolerance ? std::optional(limit(*options.Tolerance)) : std::nullopt;
  return options;
}

/// mm, at each point; infinite where there is no limit. Empty without a map.
std::vector<double> PointLimits(const CertificateOptions& options)
{
  std::vector<double> limits = options.ToleranceMap;
  const double most = options.Tolerance.value_or(Infinity);
  for (double& limit : limits)
  {
    limit = limit >= 0.0 ? std::min(limit, most) : most;
  }
  return limits;
}

ProofStatus Worse(ProofStatus a, ProofStatus b)
{
  const bool isViolated = a == ProofStatus::Violated || b == ProofStatus::Violated;
  return isViolated ? ProofStatus::Violated : std::max(a, b);
}

/// Certifies the surfaces, then their boundaries.
class Certifier
{
public:
  Certifier(const Surface& reference, const Surface& result, const CertificateOptions& options,
    const Monitor& monitor)
    : Reference(reference)
    , Result(result)
    , Options(options)
    , Progress(monitor)
  {
  }

  Certificate Run()
  {
    this->Output.Status = Check(this->Reference, this->Result, this->Options);
    if (this->Output.Status != CertificateStatus::Good)
    {
      return this->Output;
    }
    const Frame frame = FindFrame(this->Reference, this->Result);
    this->Options = WithinReach(std::move(this->Options), frame);
    this->Limits = PointLimits(this->Options);
    this->Output.Slack = Slack(
      std::max({ frame.Extent, this->Options.Tolerance.value_or(0.0), MaxFinite(this->Limits) }));
    if (!this->Options.OneSided || this->Options.WithBoundaries)
    {
      this->ReferenceSides = this->SidesOf(this->Reference);
    }
    this->ResultSides = this->SidesOf(this->Result);
    if (this->Options.WithBoundaries)
    {
      this->FindBoundaries(frame);
    }
    if (this->Options.WithSurfaces)
    {
      this->CertifySurfaces(frame);
    }
    else if (this->Options.WithBoundaries)
    {
      this->CertifyBoundaries(frame, 1.0);
    }
    this->Progress.Finish();
    if (!this->Progress.ShouldContinue())
    {
      this->Output.Status = CertificateStatus::Aborted;
    }
    return this->Output;
  }

private:
  EdgeSides SidesOf(const Surface& surface) const
  {
    return FindEdgeSides(surface.Points, surface.Triangles, this->Options.NumberOfThreads);
  }

  PairTask Task(bool areSurfaces) const
  {
    return { this->Options, this->Output.Slack, areSurfaces };
  }

  /// Bounds of the surfaces, then of boundaries, then what tells nothing about a tolerance.
  void CertifySurfaces(const Frame& frame)
  {
    const double ofBoundaries = this->Options.WithBoundaries ? 0.1 : 0.0;
    const double ofStatistics = this->Options.WithMeans ? 0.3 : 0.02;
    const Simplices reference = WholeSurface(this->Reference, this->ReferenceSides, frame);
    const Simplices result = WholeSurface(this->Result, this->ResultSides, frame);
    const PairTask task = this->Task(true);
    PairSearch search(reference, result, this->Limits, task, this->Options.OnBounds);
    search.FindBounds(this->Progress, 1.0 - ofBoundaries - ofStatistics);
    if (this->Options.WithBoundaries)
    {
      this->CertifyBoundaries(frame, ofBoundaries);
    }
    search.AddStatistics(this->Progress, ofStatistics);
    PairCertificate pair = search.Found(!this->Progress.ShouldContinue());
    this->Output.ReferenceToResult = std::move(pair.ReferenceToResult);
    this->Output.ResultToReference = std::move(pair.ResultToReference);
    this->Restore(frame, this->Output.ReferenceToResult, this->Output.ResultToReference);
    this->TakeProof(this->Output.ReferenceToResult, this->Output.ResultToReference);
  }

  void FindBoundaries(const Frame& frame)
  {
    this->ReferenceBoundary =
      FindBoundarySet(this->Reference, this->ReferenceSides, frame, this->Limits);
    this->ResultBoundary = FindBoundarySet(this->Result, this->ResultSides, frame, {});
    this->Output.BoundariesCompared = true;
    const bool ofReference = this->ReferenceBoundary.Segments.Size() > 0;
    const bool ofResult = this->ResultBoundary.Segments.Size() > 0;
    this->Output.Boundaries = ofReference
      ? (ofResult ? BoundaryPresence::Both : BoundaryPresence::ReferenceOnly)
      : (ofResult ? BoundaryPresence::ResultOnly : BoundaryPresence::Neither);
  }

  void CertifyBoundaries(const Frame& frame, double weight)
  {
    const PairTask task = this->Task(false);
    PairCertificate pair;
    if (this->Output.Boundaries == BoundaryPresence::Both)
    {
      PairSearch search(this->ReferenceBoundary.Segments, this->ResultBoundary.Segments,
        this->ReferenceBoundary.Limit, task, {});
      search.FindBounds(this->Progress, weight);
      pair = search.Found(!this->Progress.ShouldContinue());
    }
    else
    {
      pair = WithoutPartner(this->ReferenceBoundary, this->ResultBoundary, task);
    }
    this->Output.BoundaryOfReferenceToResult = std::move(pair.ReferenceToResult);
    this->Output.BoundaryOfResultToReference = std::move(pair.ResultToReference);
    this->Restore(
      frame, this->Output.BoundaryOfReferenceToResult, this->Output.BoundaryOfResultToReference);
    this->TakeProof(
      this->Output.BoundaryOfReferenceToResult, this->Output.BoundaryOfResultToReference);
  }

  void TakeProof(const DirectedCertificate& a, const DirectedCertificate& b)
  {
    this->Output.Proof = Worse(this->Output.Proof, Worse(a.Proof, b.Proof));
  }

  /// Converts positions from the local frame to input coordinates.
  void Restore(const Frame& frame, DirectedCertificate& a, DirectedCertificate& b) const
  {
    for (DistanceBounds* bounds : { &a.Distance, &a.Excess, &b.Distance, &b.Excess })
    {
      if (bounds->Triangle != None)
      {
        bounds->Position += frame.Origin;
      }
    }
  }

  const Surface& Reference;
  const Surface& Result;
  CertificateOptions Options;
  std::vector<double> Limits; // mm, at each point of the reference; empty without a map
  Stages Progress;
  EdgeSides ReferenceSides, ResultSides;
  BoundarySet ReferenceBoundary, ResultBoundary;
  Certificate Output;
};
}
}

double Certificate::Lower() const
{
  return std::max(this->ReferenceToResult.Distance.Lower, this->ResultToReference.Distance.Lower);
}

double Certificate::Upper() const
{
  return std::max(this->ReferenceToResult.Distance.Upper, this->ResultToReference.Distance.Upper);
}

Certificate Certify(const Surface& reference, const Surface& result,
  const CertificateOptions& options, const Monitor& monitor)
{
  const auto start = std::chrono::steady_clock::now();
  Certificate found = certificate::Certifier(reference, result, options, monitor).Run();
  const bool isOneEmpty = found.Status == CertificateStatus::EmptyReference ||
    found.Status == CertificateStatus::EmptyResult;
  if (isOneEmpty && (options.Tolerance || !options.ToleranceMap.empty()))
  {
    found.Proof = ProofStatus::Violated; // nothing is near to a surface without a triangle
  }
  found.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return found;
}

const char* ProofStatusWord(ProofStatus status)
{
  switch (status)
  {
    case ProofStatus::NotRequested:
      return "not_requested";
    case ProofStatus::Proved:
      return "proved";
    case ProofStatus::Violated:
      return "violated";
    case ProofStatus::Aborted:
      return "aborted";
    case ProofStatus::Undecided:
      break;
  }
  return "undecided";
}

const char* StatusSentence(CertificateStatus status)
{
  static const char* const sentences[] = { "", "the reference has no triangle with an area",
    "the result has no triangle with an area",
    "the reference has a triangle with a point that is missing, not finite or beyond 1e30 mm",
    "the result has a triangle with a point that is missing, not finite or beyond 1e30 mm",
    "a tolerance is infinite or negative, or a map has not one for each point of the reference",
    "aborted" };
  return sentences[static_cast<int>(status)];
}
}
