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
constexpr double Infinity = std::numeric_limits<double>::infinity();

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
  const auto isGood = [](double tolerance) { return !(tolerance > LargestCoordinate); };
  const std::vector<double>& map = options.ToleranceMap;
  const bool goodMap = (map.empty() || map.size() == reference.Points.size()) &&
    std::all_of(map.begin(), map.end(), isGood);
  const bool goodTolerance =
    !options.Tolerance || (*options.Tolerance >= 0.0 && isGood(*options.Tolerance));
  return goodMap && goodTolerance ? CertificateStatus::Good : CertificateStatus::BadTolerance;
}

/// mm, at each point; infinite where nothing limits. Empty without a map.
std::vector<double> Limits(const CertificateOptions& options)
{
  std::vector<double> limits = options.ToleranceMap;
  const double most = options.Tolerance.value_or(Infinity);
  for (double& limit : limits)
  {
    limit = limit >= 0.0 ? std::min(limit, most) : most;
  }
  return limits;
}

/// mm, of those that are finite.
double Largest(const std::vector<double>& limits)
{
  double largest = 0.0;
  for (const double limit : limits)
  {
    largest = std::isfinite(limit) ? std::max(largest, limit) : largest;
  }
  return largest;
}

CertificateVerdict Worse(CertificateVerdict a, CertificateVerdict b)
{
  const bool isViolated = a == CertificateVerdict::Violated || b == CertificateVerdict::Violated;
  return isViolated ? CertificateVerdict::Violated : std::max(a, b);
}

/// The certificates of surfaces and of borders, one after the other.
class Certifier
{
public:
  Certifier(const Surface& reference, const Surface& result, const CertificateOptions& options,
    const Monitor& monitor)
    : Reference(reference)
    , Result(result)
    , Options(options)
    , Limit(Limits(options))
    , Progress(monitor)
  {
  }

  Certificate Run()
  {
    this->Answer.Status = Check(this->Reference, this->Result, this->Options);
    if (this->Answer.Status != CertificateStatus::Good)
    {
      return this->Answer;
    }
    const Frame frame = FindFrame(this->Reference, this->Result);
    this->Answer.Slack = Slack(
      std::max({ frame.Extent, this->Options.Tolerance.value_or(0.0), Largest(this->Limit) }));
    if (this->Options.WithSurfaces)
    {
      this->CertifySurfaces(frame);
    }
    if (this->Options.WithBorders && this->Progress.GoesOn())
    {
      this->CertifyBorders(frame);
    }
    this->Progress.Finish();
    if (!this->Progress.GoesOn())
    {
      this->Answer = Certificate();
      this->Answer.Status = CertificateStatus::Aborted;
    }
    return this->Answer;
  }

private:
  PairTask Task(bool ofSurfaces) const { return { this->Options, this->Answer.Slack, ofSurfaces }; }

  void CertifySurfaces(const Frame& frame)
  {
    const double share = this->Options.WithBorders ? 0.9 : 1.0;
    const PairCertificate pair = CertifyPair(WholeSurface(this->Reference, frame),
      WholeSurface(this->Result, frame), this->Limit, this->Task(true), this->Progress, share);
    this->Answer.ReferenceToResult = pair.ReferenceToResult;
    this->Answer.ResultToReference = pair.ResultToReference;
    this->Restore(frame, this->Answer.ReferenceToResult, this->Answer.ResultToReference);
    this->Answer.Verdict = Worse(pair.ReferenceToResult.Verdict, pair.ResultToReference.Verdict);
  }

  void CertifyBorders(const Frame& frame)
  {
    const BorderSet reference = FindBorderSet(this->Reference, frame, this->Limit);
    const BorderSet result = FindBorderSet(this->Result, frame, {});
    const bool ofReference = reference.Segments.Size() > 0;
    const bool ofResult = result.Segments.Size() > 0;
    this->Answer.Borders = ofReference
      ? (ofResult ? BorderPresence::Both : BorderPresence::ReferenceOnly)
      : (ofResult ? BorderPresence::ResultOnly : BorderPresence::Neither);
    const PairCertificate pair = ofReference && ofResult
      ? CertifyPair(reference.Segments, result.Segments, reference.Limit, this->Task(false),
          this->Progress, this->Options.WithSurfaces ? 0.1 : 1.0)
      : WithoutPartner(reference, result, this->Task(false));
    this->Answer.BorderOfReferenceToResult = pair.ReferenceToResult;
    this->Answer.BorderOfResultToReference = pair.ResultToReference;
    this->Restore(
      frame, this->Answer.BorderOfReferenceToResult, this->Answer.BorderOfResultToReference);
    this->Answer.Verdict = Worse(
      this->Answer.Verdict, Worse(pair.ReferenceToResult.Verdict, pair.ResultToReference.Verdict));
  }

  /// Back from the local frame.
  void Restore(const Frame& frame, DirectedCertificate& a, DirectedCertificate& b) const
  {
    for (DistanceBounds* bounds : { &a.Distance, &a.Excess, &b.Distance, &b.Excess })
    {
      if (bounds->Triangle != None)
      {
        bounds->Place += frame.Origin;
      }
    }
  }

  const Surface& Reference;
  const Surface& Result;
  const CertificateOptions& Options;
  const std::vector<double> Limit; // mm, at each point of the reference; empty without a map
  Stages Progress;
  Certificate Answer;
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
  Certificate answer = certificate::Certifier(reference, result, options, monitor).Run();
  answer.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

const char* VerdictWord(CertificateVerdict verdict)
{
  static const char* const words[] = { "not_asked", "proved", "violated", "undecided" };
  return words[static_cast<int>(verdict)];
}

const char* StatusSentence(CertificateStatus status)
{
  static const char* const sentences[] = { "", "the reference has no triangles",
    "the result has no triangles",
    "the reference has a triangle with a point that is not there, not finite or beyond 1e30 mm",
    "the result has a triangle with a point that is not there, not finite or beyond 1e30 mm",
    "a tolerance is infinite or negative, or a map has not one for each point of the reference",
    "aborted" };
  return sentences[static_cast<int>(status)];
}
}
