// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ResultProof.h"

#include "Certificate/Certificate.h"
#include "StageClock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bonedecimate
{
namespace
{
/// How closely the bounds are looked for: of the whole, as a share of it or of the largest error, whatever is more; of a
/// triangle, as a share of the largest error, or of the largest tolerance if there is none. The gate keeps twice the first
/// share away from the largest error. What is flat, and so at a distance of 0, would otherwise be cut along every edge of
/// the input to the last digit.
constexpr double WholeGap = 1e-4;
constexpr double TriangleGap = 0.02;

CertificateOptions QuestionOf(const Options& options, const std::vector<double>* tolerances)
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
  if (options.PromisesError())
  {
    question.Tolerance = largest = options.MaximumError;
  }
  question.ResultTriangleGap = TriangleGap * largest;
  question.RelativeGap = WholeGap;
  question.LeastGap = WholeGap * largest;
  question.WithBorders = options.MergePoints;
  question.ReferenceTriangleGap = options.MeasureInputDistances ? question.ResultTriangleGap : 0.0;
  question.NumberOfThreads = options.NumberOfThreads;
  return question;
}

ProvedDistance BoundsOf(const DirectedCertificate& directed)
{
  return { directed.Distance.Lower, directed.Distance.Upper };
}

ErrorProof ProofOf(const Certificate& found, const CertificateOptions& question)
{
  ErrorProof proof;
  proof.WasMade = true;
  proof.Verdict = found.Verdict;
  proof.Tolerance = question.Tolerance.value_or(0.0);
  proof.InputToOutput = BoundsOf(found.ReferenceToResult);
  proof.OutputToInput = BoundsOf(found.ResultToReference);
  proof.BordersCompared = question.WithBorders;
  proof.Borders = found.Borders;
  if (question.WithBorders)
  {
    proof.BorderInputToOutput = BoundsOf(found.BorderOfReferenceToResult);
    proof.BorderOutputToInput = BoundsOf(found.BorderOfResultToReference);
  }
  return proof;
}

/// mm; empty if there are no bounds of triangles.
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

void ProveAgainst(const Surface& reference, const CertificateOptions& question,
  const Monitor& monitor, Result& answer)
{
  const Certificate found = Certify(reference, answer.Surface, question, monitor);
  Report& report = answer.Report;
  if (found.Status == CertificateStatus::Aborted)
  {
    return;
  }
  if (found.Status != CertificateStatus::Good)
  {
    report.Proof.WasMade = true; // of what cannot be judged nothing is proved
    report.Proof.Verdict = CertificateVerdict::Undecided;
    report.Proof.Tolerance = question.Tolerance.value_or(0.0);
    constexpr double any = std::numeric_limits<double>::infinity();
    report.Proof.InputToOutput.Upper = report.Proof.OutputToInput.Upper = any;
    return;
  }
  report.Proof = ProofOf(found, question);
  report.BordersMeasured = report.DistancesMeasured && found.Borders == BorderPresence::Both;
  report.BorderInputToOutput = report.Proof.BorderInputToOutput;
  report.BorderOutputToInput = report.Proof.BorderOutputToInput;
  answer.ErrorBound = BoundsAtPoints(answer.Surface, found.ResultToReference.TriangleUpper);
  answer.InputErrorBound = BoundsAtPoints(reference, found.ReferenceToResult.TriangleUpper);
}

void ProveAgainst(const KeptSurface& reference, const CertificateOptions& question,
  const Monitor& monitor, Result& answer)
{
  ProveAgainst(reference.Surface, question, monitor, answer);
  answer.Report.Proof.TrianglesLeftOut = reference.LeftOut;
}

/// Of tolerances that hold against another surface than the largest error: the worse verdict counts.
void AddMapVerdict(const Surface& input, const Options& options, const std::vector<double>& map,
  const Monitor& monitor, Result& answer)
{
  CertificateOptions question;
  question.ToleranceMap = map;
  question.TightBounds = false;
  question.WithBorders = options.MergePoints;
  question.NumberOfThreads = options.NumberOfThreads;
  const Certificate found = Certify(input, answer.Surface, question, monitor);
  if (found.Status == CertificateStatus::Aborted)
  {
    answer.Report.Proof = {};
    answer.ErrorBound.clear();
    return;
  }
  CertificateVerdict& verdict = answer.Report.Proof.Verdict;
  const bool isJudged = found.Status == CertificateStatus::Good;
  const CertificateVerdict here = isJudged ? found.Verdict : CertificateVerdict::Undecided;
  const bool isWorse = here == CertificateVerdict::Violated ||
    (here == CertificateVerdict::Undecided && verdict == CertificateVerdict::Proved);
  verdict = isWorse ? here : verdict;
}
}

bool WantsProof(const Options& options, bool hasTolerances)
{
  return options.ProveResult &&
    (options.PromisesError() || (hasTolerances && options.Mode != Mode::Thesis));
}

void ProveResult(const Surface& input, const CleanSurface& cleaned, const Options& options,
  const Monitor& monitor, Result& answer, const std::vector<double>* tolerances,
  const KeptSurface* reference)
{
  const StageClock clock;
  if (reference != nullptr)
  {
    Options question = options;
    question.MeasureInputDistances = false; // bounds at points of the reference are nobody's
    const double half = tolerances != nullptr ? 0.5 : 1.0;
    ProveAgainst(*reference, QuestionOf(question, nullptr), PartOf(monitor, 0.0, half), answer);
    if (tolerances != nullptr && answer.Report.Proof.WasMade)
    {
      AddMapVerdict(
        KeptPart(input, cleaned).Surface, options, *tolerances, PartOf(monitor, half, 1.0), answer);
    }
  }
  else
  {
    const CertificateOptions question = QuestionOf(options, tolerances);
    if (cleaned.InputTriangle.size() < input.Triangles.size())
    {
      ProveAgainst(KeptPart(input, cleaned), question, monitor, answer);
    }
    else
    {
      ProveAgainst(input, question, monitor, answer);
    }
  }
  answer.Report.Seconds.Prove = clock.Seconds();
}
}
