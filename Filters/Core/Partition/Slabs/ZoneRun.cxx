// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ZoneRun.h"

#include "ContinuedProof.h"
#include "Proof/Guard/GuardReach.h"
#include "Run/Decimate.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// The separations of a draft look two errors from triangles that are up to one error outside.
constexpr double ErrorsOfMargin = 3.02;
/// Distance around the zone within which the proof covers the original, in largest errors.
constexpr double ErrorsOfProof = 1.001;
/// Progress at which the proof begins.
constexpr double ProvedFrom = 0.85;

Zone Widened(Zone zone, double width)
{
  zone.Low -= width;
  zone.High += width;
  return zone;
}

/// The edges of triangles that do not reach the zone.
std::vector<std::array<Index, 2>> EdgesOutside(const Surface& surface, const Zone& zone)
{
  std::vector<std::array<Index, 2>> edges;
  for (const Triangle& c : surface.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::array<Index, 2> edge = { c[i], c[(i + 1) % 3] };
      const std::array<Vector3, 2> ends = { surface.Points[edge[0]], surface.Points[edge[1]] };
      if (!zone.MayReach(ends, 0.0))
      {
        edges.push_back(edge);
      }
    }
  }
  return edges;
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
  part.CutEdges = EdgesOutside(input.Strip.Shape, input.BoundaryZone);
  part.ReferenceCutEdges = EdgesOutside(input.Original.Shape, input.BoundaryZone);
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
    const ContinuedProof proof =
      ProveContinued({ input.Original.Shape, near.Shape, input.Strip.Shape, zone.Run.Surface },
        options, false, monitor ? PartOf(monitor, ProvedFrom, 1.0) : monitor);
    zone.Proof = proof.Status;
    zone.OriginalToResult = proof.OriginalToResult;
    zone.ResultToOriginal = proof.ResultToOriginal;
  }
  return zone;
}
}
