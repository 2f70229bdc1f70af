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
    , Limits(PointLimits(options))
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
    this->Output.Slack = Slack(
      std::max({ frame.Extent, this->Options.Tolerance.value_or(0.0), MaxFinite(this->Limits) }));
    if (!this->Options.OneSided || this->Options.WithBoundaries)
    {
      this->ReferenceSides = this->SidesOf(this->Reference);
    }
    this->ResultSides = this->SidesOf(this->Result);
    if (this->Options.WithSurfaces)
    {
      this->CertifySurfaces(frame);
    }
    if (this->Options.WithBoundaries && this->Progress.ShouldContinue())
    {
      this->CertifyBoundaries(frame);
    }
    this->Progress.Finish();
    if (!this->Progress.ShouldContinue())
    {
      this->Output = Certificate();
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

  void CertifySurfaces(const Frame& frame)
  {
    const double weight = this->Options.WithBoundaries ? 0.9 : 1.0;
    const PairCertificate pair =
      CertifyPair(WholeSurface(this->Reference, this->ReferenceSides, frame),
        WholeSurface(this->Result, this->ResultSides, frame), this->Limits, this->Task(true),
        this->Progress, weight);
    this->Output.ReferenceToResult = pair.ReferenceToResult;
    this->Output.ResultToReference = pair.ResultToReference;
    this->Restore(frame, this->Output.ReferenceToResult, this->Output.ResultToReference);
    this->Output.Proof = Worse(pair.ReferenceToResult.Proof, pair.ResultToReference.Proof);
  }

  void CertifyBoundaries(const Frame& frame)
  {
    const BoundarySet reference =
      FindBoundarySet(this->Reference, this->ReferenceSides, frame, this->Limits);
    const BoundarySet result = FindBoundarySet(this->Result, this->ResultSides, frame, {});
    const bool ofReference = reference.Segments.Size() > 0;
    const bool ofResult = result.Segments.Size() > 0;
    this->Output.Boundaries = ofReference
      ? (ofResult ? BoundaryPresence::Both : BoundaryPresence::ReferenceOnly)
      : (ofResult ? BoundaryPresence::ResultOnly : BoundaryPresence::Neither);
    const PairCertificate pair = ofReference && ofResult
      ? CertifyPair(reference.Segments, result.Segments, reference.Limit, this->Task(false),
          this->Progress, this->Options.WithSurfaces ? 0.1 : 1.0)
      : WithoutPartner(reference, result, this->Task(false));
    this->Output.BoundaryOfReferenceToResult = pair.ReferenceToResult;
    this->Output.BoundaryOfResultToReference = pair.ResultToReference;
    this->Restore(
      frame, this->Output.BoundaryOfReferenceToResult, this->Output.BoundaryOfResultToReference);
    this->Output.Proof =
      Worse(this->Output.Proof, Worse(pair.ReferenceToResult.Proof, pair.ResultToReference.Proof));
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
  const CertificateOptions& Options;
  const std::vector<double> Limits; // mm, at each point of the reference; empty without a map
  Stages Progress;
  EdgeSides ReferenceSides, ResultSides;
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
  static const char* const sentences[] = { "", "the reference has no triangles",
    "the result has no triangles",
    "the reference has a triangle with a point that is missing, not finite or beyond 1e30 mm",
    "the result has a triangle with a point that is missing, not finite or beyond 1e30 mm",
    "a tolerance is infinite or negative, or a map has not one for each point of the reference",
    "aborted" };
  return sentences[static_cast<int>(status)];
}
}
