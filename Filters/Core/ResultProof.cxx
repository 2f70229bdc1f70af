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
/// How closely the bounds are looked for: of the whole, as a share of it; of a triangle, as a share of the largest error, or
/// of the largest tolerance if there is none. The gate keeps twice the first share away from the largest error.
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
  question.WithBorders = options.MergePoints;
  question.ReferenceTriangleGap = options.MeasureInputDistances ? question.ResultTriangleGap : 0.0;
  question.NumberOfThreads = options.NumberOfThreads;
  return question;
}

/// All points, and the triangles that cleaning kept, in the order of the input.
Surface KeptPart(const Surface& input, std::vector<Index> triangles)
{
  std::sort(triangles.begin(), triangles.end());
  Surface kept;
  kept.Points = input.Points;
  kept.Triangles.reserve(triangles.size());
  for (const Index triangle : triangles)
  {
    kept.Triangles.push_back(input.Triangles[triangle]);
  }
  return kept;
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
  if (found.Status != CertificateStatus::Good)
  {
    return; // somebody aborted
  }
  Report& report = answer.Report;
  report.Proof = ProofOf(found, question);
  report.BordersMeasured = report.DistancesMeasured && found.Borders == BorderPresence::Both;
  report.BorderInputToOutput = report.Proof.BorderInputToOutput;
  report.BorderOutputToInput = report.Proof.BorderOutputToInput;
  answer.ErrorBound = BoundsAtPoints(answer.Surface, found.ResultToReference.TriangleUpper);
  answer.InputErrorBound = BoundsAtPoints(reference, found.ReferenceToResult.TriangleUpper);
}
}

bool WantsProof(const Options& options, bool hasTolerances)
{
  return options.ProveResult &&
    (options.PromisesError() || (hasTolerances && options.Mode != Mode::Thesis));
}

void ProveResult(const Surface& input, const CleanSurface& cleaned, const Options& options,
  const Monitor& monitor, Result& answer, const std::vector<double>* tolerances)
{
  const StageClock clock;
  const CertificateOptions question = QuestionOf(options, tolerances);
  const std::int64_t leftOut = cleaned.Statistics.DroppedTriangles;
  if (leftOut > 0)
  {
    ProveAgainst(KeptPart(input, cleaned.InputTriangle), question, monitor, answer);
    answer.Report.Proof.TrianglesLeftOut = leftOut;
  }
  else
  {
    ProveAgainst(input, question, monitor, answer);
  }
  answer.Report.Seconds.Prove = clock.Seconds();
}
}
