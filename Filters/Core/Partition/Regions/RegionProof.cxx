// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionProof.h"

#include "Base/StageClock.h"
#include "Mesh/Cleaning.h"
#include "Run/Output/ResultProof.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// The triangles that changed.
Surface ChangedTriangles(const RegionPart& part)
{
  Surface changed = { part.Surface.Points, {} };
  std::size_t next = 0;
  for (std::size_t t = 0; t < part.Triangles.size(); ++t)
  {
    if (next < part.Covered.Triangles.size() && part.Covered.Triangles[next] == part.Triangles[t])
    {
      changed.Triangles.push_back(part.Surface.Triangles[t]);
      ++next;
    }
  }
  return changed;
}

/// The triangles that replace those of the region.
Surface NewTriangles(const RegionPart& part)
{
  Surface renewed = { part.Result.Surface.Points, {} };
  for (std::size_t t = 0; t < part.OldTriangle.size(); ++t)
  {
    if (part.OldTriangle[t] == None)
    {
      renewed.Triangles.push_back(part.Result.Surface.Triangles[t]);
    }
  }
  return renewed;
}

/// The same limit of all points of the region is one for the surface, which is much faster to
/// certify than a map.
CertificateOptions SurfaceOptions(const Options& options, const RegionPart& part)
{
  const auto limitOf = [&](double tolerance)
  {
    return tolerance < 0.0 || (options.BoundsError() && options.MaximumError < tolerance)
      ? options.MaximumError
      : tolerance;
  };
  const std::vector<double>& tolerances = part.Covered.Tolerances;
  const double first = limitOf(tolerances.front());
  const bool areSame = std::all_of(tolerances.begin(), tolerances.end(),
    [&](double tolerance) { return limitOf(tolerance) == first; });
  Options same = options;
  same.MaximumError = areSame ? first : options.MaximumError;
  CertificateOptions question = ProofOptions(same, areSame ? nullptr : &part.Tolerances);
  question.WithBoundaries = false;
  return question;
}

/// mm, a lower bound of the distance from one position to the surface.
double DistanceFromBelow(const DistanceBounds& from, const Surface& surface, int threads)
{
  CertificateOptions question;
  question.WithBoundaries = false;
  question.NumberOfThreads = threads;
  const Surface position = { { from.Position }, { { 0, 0, 0 } } };
  const Certificate found = Certify(position, surface, question);
  return std::max(0.0, std::min(from.Lower, found.ReferenceToResult.Distance.Lower));
}

/// False if the certificate does not prove it.
bool ProveSurfaces(const Options& options, const Monitor& monitor, RegionPart& part)
{
  const Surface changed = ChangedTriangles(part);
  const Surface renewed = NewTriangles(part);
  const Certificate found = Certify(changed, renewed, SurfaceOptions(options, part), monitor);
  if (found.Status != CertificateStatus::Good || found.Proof != ProofStatus::Proved)
  {
    return false;
  }
  const int threads = options.NumberOfThreads;
  const DistanceBounds& there = found.ReferenceToResult.Distance;
  const DistanceBounds& back = found.ResultToReference.Distance;
  ErrorProof& proof = part.Result.Report.Proof;
  proof.InputToOutput = { DistanceFromBelow(there, part.Result.Surface, threads), there.Upper };
  proof.OutputToInput = { DistanceFromBelow(back, part.Surface, threads), back.Upper };
  part.Result.ErrorBound = BoundsAtPoints(renewed, found.ResultToReference.TriangleUpper);
  for (double& bound : part.Result.ErrorBound)
  {
    bound = std::isnan(bound) ? 0.0 : bound; // of an unchanged point
  }
  return true;
}

/// False if the certificate does not prove it.
bool ProveBoundaries(const Options& options, const Monitor& monitor, RegionPart& part)
{
  CertificateOptions question = ProofOptions(options, &part.Tolerances);
  question.WithSurfaces = false;
  const Certificate found = Certify(part.Surface, part.Result.Surface, question, monitor);
  const DistanceBounds& there = found.BoundaryOfReferenceToResult.Distance;
  const DistanceBounds& back = found.BoundaryOfResultToReference.Distance;
  ErrorProof& proof = part.Result.Report.Proof;
  proof.BoundaryInputToOutput = { there.Lower, there.Upper };
  proof.BoundaryOutputToInput = { back.Lower, back.Upper };
  return found.Status == CertificateStatus::Good && found.Proof == ProofStatus::Proved;
}
}

void ProvePart(const Options& options, bool hasBoundaries, const Monitor& monitor, RegionPart& part)
{
  const StageClock clock;
  const bool isProved = ProveSurfaces(options, PartOf(monitor, 0.0, 0.5), part) &&
    (!hasBoundaries || !options.MergePoints ||
      ProveBoundaries(options, PartOf(monitor, 0.5, 0.6), part));
  if (isProved)
  {
    part.Result.Report.Proof.WasMade = true;
    part.Result.Report.Proof.Status = ProofStatus::Proved;
  }
  else
  {
    part.Result.Report.Proof = {};
    CleanSurface kept; // of which no triangle was dropped
    kept.InputTriangle.resize(part.Surface.Triangles.size());
    ProveResult(
      part.Surface, kept, options, PartOf(monitor, 0.6, 1.0), part.Result, &part.Tolerances);
  }
  monitor(1.0);
  part.Result.Report.Seconds.Prove = clock.Seconds();
}
}
