// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RefineStage.h"

#include "CollapseStage.h"
#include "Refinement.h"
#include "SlackRefinement.h"

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

/// Without an error bound. False if the monitor stopped it.
bool RefineAndCollapse(const StageInput& input, Refinement& refinement, const Monitor& monitor)
{
  constexpr double begunAt = 0.3;
  constexpr double sweptAt = 0.4; // of a round
  const RefineSettings& settings = input.Mode.Refine;
  const int rounds = input.MeshEditor.LimitsEdits() ? settings.VoxelRounds : 1;
  const Monitor tell = PartOf(monitor, begunAt, 1.0);
  bool goesOn = refinement.Begin(PartOf(monitor, 0.0, begunAt));
  for (int i = 0; i < rounds && goesOn; ++i)
  {
    const Monitor round = PartOf(tell, static_cast<double>(i) / rounds, (i + 1.0) / rounds);
    goesOn = refinement.Sweep(settings.SweepsBefore, PartOf(round, 0.0, sweptAt)) &&
      CollapseLast(input, refinement, PartOf(round, sweptAt, 1.0));
  }
  return goesOn;
}

/// With an error bound: by how much of it is left. False if the monitor stopped it.
bool UseSlack(const StageInput& input, const Monitor& monitor)
{
  constexpr double begunAt = 0.1;
  constexpr double sweptAt = 0.6; // of a round
  if (HasReachedFaces(input))
  {
    return true;
  }
  const int rounds = input.Mode.Refine.ProvedRounds;
  const Monitor tell = PartOf(monitor, begunAt, 1.0);
  const Monitor still = [&monitor](double) { return monitor(1.0); };
  SlackRefinement slack(input.MeshEditor, input.Threads);
  bool goesOn = slack.Begin(PartOf(monitor, 0.0, begunAt));
  for (int i = 0; i < rounds && goesOn && !HasReachedFaces(input); ++i)
  {
    const Monitor round = PartOf(tell, static_cast<double>(i) / rounds, (i + 1.0) / rounds);
    goesOn = slack.Sweep(input.Mode.Refine.ProvedSweeps, PartOf(round, 0.0, sweptAt)) &&
      slack.Collapse(input.Stops.Faces, PartOf(round, sweptAt, 1.0));
  }
  for (const double farthest : { 1.25, 1.4 })
  {
    goesOn = goesOn &&
      (HasReachedFaces(input) || !input.Mode.Refine.ForcesCollapses ||
        (slack.Force(input.Stops.Faces, farthest, still) && slack.Sweep(1, still)));
  }
  return goesOn;
}

/// False if the monitor stopped it.
bool Refine(const StageInput& input, const Monitor& monitor)
{
  constexpr double slackTo = 0.65;
  constexpr double collapsedAt = 0.7;
  const RefineSettings& settings = input.Mode.Refine;
  Refinement refinement(input.MeshEditor, *input.InitialMesh, input.Threads);
  if (input.MeshEditor.HasErrorBound())
  {
    return UseSlack(input, PartOf(monitor, 0.0, slackTo)) &&
      refinement.Begin(PartOf(monitor, slackTo, collapsedAt)) &&
      refinement.Sweep(settings.ProvedSweepsAfter, PartOf(monitor, collapsedAt, 1.0));
  }
  const bool fewRemain = input.Stops.Faces < FewTriangles * input.FacesAtStart;
  return RefineAndCollapse(input, refinement, PartOf(monitor, 0.0, collapsedAt)) &&
    refinement.Sweep(
      fewRemain ? settings.SweepsIfFew : settings.SweepsAfter, PartOf(monitor, collapsedAt, 1.0));
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
