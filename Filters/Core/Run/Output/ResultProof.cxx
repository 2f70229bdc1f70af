// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ResultProof.h"

#include "Base/StageClock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bonedecimate
{
namespace
{
/// Relative gaps of the bounds. The first is relative to the bound of the whole or to the
/// largest error, whichever is larger; the second, of triangles, to the largest error, or to the
/// largest tolerance without one. The error bound of edits keeps a margin of twice the first
/// below the largest error. Without these gaps flat parts, at a distance of 0, would be cut
/// along every edge of the input.
constexpr double WholeGap = 1e-4;
constexpr double TriangleGap = 0.05;
}

CertificateOptions ProofOptions(const Options& options, const std::vector<double>* tolerances)
{
  CertificateOptions question;
  double largest = 0.0; // mm
  if (tolerances != nullptr)
  {
    question.ToleranceMap = *tolerances;
    for (const double tolerance : *tolerances)
    {
      largest = std::fmax(largest, tolerance);
    }
  }
  if (options.BoundsError())
  {
    question.Tolerance = largest = options.MaximumError;
  }
  question.ResultTriangleGap = TriangleGap * largest;
  question.RelativeGap = WholeGap;
  question.MinGap = WholeGap * largest;
  question.WithBoundaries = options.MergePoints;
  question.ReferenceTriangleGap = options.MeasureInputDistances ? question.ResultTriangleGap : 0.0;
  question.NumberOfThreads = options.NumberOfThreads;
  return question;
}

//------------------------------------------------------------------------------
std::vector<double> BoundsAtPoints(
  const Surface& surface, const std::vector<double>& triangleBounds)
{
  if (triangleBounds.empty())
  {
    return {};
  }
  std::vector<double> bounds(surface.Points.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t t = 0; t < triangleBounds.size(); ++t)
  {
    for (const Index corner : surface.Triangles[t])
    {
      bounds[corner] = std::fmax(bounds[corner], triangleBounds[t]);
    }
  }
  return bounds;
}

namespace
{
ProvedDistance BoundsOf(const DirectedCertificate& directed)
{
  return { directed.Distance.Lower, directed.Distance.Upper };
}

ErrorProof ProofOf(const Certificate& found, const CertificateOptions& question)
{
  ErrorProof proof;
  proof.WasMade = true;
  proof.Status = found.Proof;
  proof.Tolerance = question.Tolerance.value_or(0.0);
  proof.InputToOutput = BoundsOf(found.ReferenceToResult);
  proof.OutputToInput = BoundsOf(found.ResultToReference);
  proof.BoundariesCompared = question.WithBoundaries;
  proof.Boundaries = found.Boundaries;
  if (question.WithBoundaries)
  {
    proof.BoundaryInputToOutput = BoundsOf(found.BoundaryOfReferenceToResult);
    proof.BoundaryOutputToInput = BoundsOf(found.BoundaryOfResultToReference);
  }
  return proof;
}

void ProveAgainst(const Surface& reference, const CertificateOptions& question,
  const Monitor& monitor, Result& output)
{
  const Certificate found = Certify(reference, output.Surface, question, monitor);
  Report& report = output.Report;
  if (found.Status == CertificateStatus::Aborted)
  {
    return;
  }
  if (found.Status != CertificateStatus::Good)
  {
    report.Proof.WasMade = true; // surfaces that cannot be certified are undecided
    report.Proof.Status = ProofStatus::Undecided;
    report.Proof.Tolerance = question.Tolerance.value_or(0.0);
    constexpr double any = std::numeric_limits<double>::infinity();
    report.Proof.InputToOutput.Upper = report.Proof.OutputToInput.Upper = any;
    return;
  }
  report.Proof = ProofOf(found, question);
  report.BoundariesMeasured =
    report.DistancesMeasured && found.Boundaries == BoundaryPresence::Both;
  report.BoundaryInputToOutput = report.Proof.BoundaryInputToOutput;
  report.BoundaryOutputToInput = report.Proof.BoundaryOutputToInput;
  output.ErrorBound = BoundsAtPoints(output.Surface, found.ResultToReference.TriangleUpper);
  output.InputErrorBound = BoundsAtPoints(reference, found.ReferenceToResult.TriangleUpper);
}

/// With a reference, tolerances hold relative to the input and the largest error to the
/// reference: the worse status is reported.
void AddMapStatus(const Surface& input, const Options& options, const std::vector<double>& map,
  const Monitor& monitor, Result& output)
{
  CertificateOptions question;
  question.ToleranceMap = map;
  question.TightBounds = false;
  question.WithBoundaries = options.MergePoints;
  question.NumberOfThreads = options.NumberOfThreads;
  const Certificate found = Certify(input, output.Surface, question, monitor);
  if (found.Status == CertificateStatus::Aborted)
  {
    output.Report.Proof = {};
    output.ErrorBound.clear();
    return;
  }
  ProofStatus& status = output.Report.Proof.Status;
  const bool isDecided = found.Status == CertificateStatus::Good;
  const ProofStatus here = isDecided ? found.Proof : ProofStatus::Undecided;
  status = WorseOf(status, here);
}
}

bool WantsProof(const Options& options, bool hasTolerances)
{
  return options.ProveResult && (options.BoundsError() || (hasTolerances && options.ProvesError()));
}

void MarkAborted(bool wantsProof, Report& report)
{
  report.Stop = StopReason::Aborted;
  if (wantsProof && !report.Proof.WasMade)
  {
    report.Proof.Status = ProofStatus::Aborted;
  }
}

void ProveResult(const Surface& input, const CleanSurface& cleaned, const Options& options,
  const Monitor& monitor, Result& output, const std::vector<double>* tolerances,
  const KeptSurface* reference)
{
  const StageClock clock;
  if (reference != nullptr)
  {
    Options question = options;
    question.MeasureInputDistances = false; // points of the reference are not points of the input
    const double half = tolerances != nullptr ? 0.5 : 1.0;
    ProveAgainst(
      reference->Surface, ProofOptions(question, nullptr), PartOf(monitor, 0.0, half), output);
    if (tolerances != nullptr && output.Report.Proof.WasMade)
    {
      AddMapStatus(
        KeptPart(input, cleaned).Surface, options, *tolerances, PartOf(monitor, half, 1.0), output);
    }
  }
  else
  {
    const CertificateOptions question = ProofOptions(options, tolerances);
    if (cleaned.InputTriangle.size() < input.Triangles.size())
    {
      ProveAgainst(KeptPart(input, cleaned).Surface, question, monitor, output);
    }
    else
    {
      ProveAgainst(input, question, monitor, output);
    }
  }
  output.Report.Seconds.Prove = clock.Seconds();
}
}
