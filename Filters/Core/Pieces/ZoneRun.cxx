// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ZoneRun.h"

#include "Certificate/Certificate.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
constexpr double ErrorsOfReach = 6.001;
constexpr double ErrorsOfMargin = 2.001;
/// Of the largest error, around which the proof covers the original.
constexpr double ErrorsOfProof = 1.001;
/// Of the progress.
constexpr double ProvedFrom = 0.85;

Zone Widened(Zone zone, double width)
{
  zone.Low -= width;
  zone.High += width;
  return zone;
}

/// Triangles with all corners in the zone.
Surface InZone(const Surface& surface, const Zone& zone)
{
  Surface inside = { surface.Points, {} };
  std::copy_if(surface.Triangles.begin(), surface.Triangles.end(),
    std::back_inserter(inside.Triangles),
    [&](const Triangle& c)
    {
      return std::all_of(
        c.begin(), c.end(), [&](Index v) { return zone.Contains(surface.Points[v]); });
    });
  return inside;
}

/// Of every point of the first surface, to the second one.
void Prove(const Surface& from, const Surface& to, const Options& options, const Monitor& monitor,
  ProvedDistance& distance, ProofStatus& status)
{
  CertificateOptions question;
  question.Tolerance = options.MaximumError;
  question.TightBounds = false;
  question.WithBoundaries = false;
  question.NumberOfThreads = options.NumberOfThreads;
  if (from.Triangles.empty())
  {
    return;
  }
  const Certificate found = Certify(from, to, question, monitor);
  const DirectedCertificate& there = found.ReferenceToResult;
  distance = { there.Distance.Lower, there.Distance.Upper };
  const ProofStatus proof =
    found.Status == CertificateStatus::Good ? there.Proof : ProofStatus::Undecided;
  const bool isWorse = proof == ProofStatus::Violated ||
    (proof == ProofStatus::Undecided && status == ProofStatus::Proved);
  status = isWorse ? proof : status;
}
}

double ZoneReach(double largestError)
{
  return ErrorsOfReach * largestError;
}

//------------------------------------------------------------------------------
double ZoneMargin(double largestError)
{
  return ErrorsOfMargin * largestError;
}

//------------------------------------------------------------------------------
ZoneResult DecimateZone(const ZoneInput& input, const Options& options,
  const LabelMapSource* source, bool inputIsSingle, const Monitor& monitor)
{
  LabelMapSource ofStrip = source != nullptr ? *source : LabelMapSource();
  LabelMapSource ofOriginal = ofStrip;
  ofStrip.OfTriangle = input.Strip.Labels;
  ofOriginal.OfTriangle = input.Original.Labels;
  SurfacePart part;
  part.IsShared = input.IsFinished;
  for (std::size_t i = 0; i < part.IsShared.size(); ++i)
  {
    part.IsShared[i] |= input.EditZone.Contains(input.Strip.Shape.Points[i]) ? 0 : 1;
  }
  part.EditZone = input.EditZone;
  part.BoundaryZone = input.BoundaryZone;
  part.Reference = &input.Original.Shape;
  part.ReferenceLabels = &ofOriginal;
  RunInputs inputs;
  inputs.InputIsSingle = inputIsSingle;
  inputs.LabelMap = source != nullptr ? &ofStrip : nullptr;
  inputs.Part = &part;
  ZoneResult zone;
  zone.Run = Decimate(
    input.Strip.Shape, options, monitor ? PartOf(monitor, 0.0, ProvedFrom) : monitor, inputs);
  const Report& report = zone.Run.Report;
  if (options.ProveResult && report.Status == InputStatus::Good &&
    report.Stop != StopReason::Aborted)
  {
    const SurfacePiece near =
      CutBetween(input.Original, Widened(input.EditZone, ErrorsOfProof * options.MaximumError));
    const Monitor prove = monitor ? PartOf(monitor, ProvedFrom, 1.0) : monitor;
    const Monitor silent = [&](double) { return !prove || prove(0.0); };
    zone.Proof = ProofStatus::Proved;
    Prove(near.Shape, zone.Run.Surface, options, silent, zone.OriginalToResult, zone.Proof);
    Prove(InZone(zone.Run.Surface, input.EditZone), input.Original.Shape, options, silent,
      zone.ResultToOriginal, zone.Proof);
  }
  return zone;
}
}
