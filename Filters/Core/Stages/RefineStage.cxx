// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RefineStage.h"

#include "CollapseStage.h"
#include "Refinement.h"

namespace bonedecimate
{
namespace
{
/// Below that ratio of the original triangles, few remain.
constexpr double FewTriangles = 0.2;

bool HasReachedFaces(const StageInput& input)
{
  return input.MeshEditor.Mesh().NumberOfFaces() <= input.Stops.Faces;
}

/// Down to the target. False if the monitor stopped it.
bool CollapseLast(const StageInput& input, Refinement& refinement, const Monitor& monitor)
{
  constexpr double sweepFrom = 0.99;
  if (HasReachedFaces(input))
  {
    return true;
  }
  if (!input.MeshEditor.LimitsEdits() &&
    !refinement.CollapseTo(
      input.Stops.Faces, input.Mode.Refine.EdgesOfCollapse, PartOf(monitor, 0.0, sweepFrom)))
  {
    return false;
  }
  if (HasReachedFaces(input))
  {
    return monitor(1.0);
  }
  input.MeshEditor.DistributeVolumeBudget();
  input.MeshEditor.RenewQuadrics(input.Threads);
  const Monitor last = PartOf(monitor, sweepFrom, 1.0);
  const Monitor still = [&last](double) { return last(0.0); };
  return SweepTo(input, input.Stops.Faces, still) != StopReason::Aborted && refinement.Begin(last);
}

int RoundsOf(const StageInput& input)
{
  const RefineSettings& settings = input.Mode.Refine;
  const int limited =
    input.MeshEditor.HasErrorBound() ? settings.ProvedRounds : settings.VoxelRounds;
  return input.MeshEditor.LimitsEdits() ? limited : 1;
}

/// False if the monitor stopped it.
bool Refine(const StageInput& input, const Monitor& monitor)
{
  constexpr double roundsFrom = 0.2;
  constexpr double roundsTo = 0.7;
  constexpr double sweptAt = 0.4; // of a round
  const RefineSettings& settings = input.Mode.Refine;
  Refinement refinement(input.MeshEditor, *input.InitialMesh, input.Threads);
  const bool fewRemain = input.Stops.Faces < FewTriangles * input.FacesAtStart;
  const int rounds = RoundsOf(input);
  const Monitor tell = PartOf(monitor, roundsFrom, roundsTo);
  bool goesOn = refinement.Begin(PartOf(monitor, 0.0, roundsFrom));
  for (int i = 0; i < rounds && goesOn; ++i)
  {
    const Monitor round = PartOf(tell, static_cast<double>(i) / rounds, (i + 1.0) / rounds);
    goesOn = refinement.Sweep(settings.SweepsBefore, PartOf(round, 0.0, sweptAt)) &&
      CollapseLast(input, refinement, PartOf(round, sweptAt, 1.0));
  }
  return goesOn &&
    refinement.Sweep(
      fewRemain ? settings.SweepsIfFew : settings.SweepsAfter, PartOf(monitor, roundsTo, 1.0));
}
}

StopReason RefineStage(const StageInput& input, const Monitor& monitor)
{
  if (!Refine(input, monitor))
  {
    return StopReason::Aborted;
  }
  const StopCriterion stop(input.MeshEditor, input.Stops);
  return stop.IsReached()            ? stop.Reason()
    : input.MeshEditor.MetItsLimit() ? StopReason::ErrorReached
                                     : StopReason::NothingLeft;
}
}
