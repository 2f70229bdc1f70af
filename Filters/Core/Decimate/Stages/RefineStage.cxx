// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RefineStage.h"

#include "CollapseStage.h"
#include "Refinement.h"
#include "ShapeStage.h"
#include "SlackRefinement.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
/// Fraction of the initial triangles below which few triangles remain.
constexpr double FewTriangles = 0.2;

/// Collapses down to the target. False if the monitor requests a stop.
bool CollapseLast(const StageInput& input, Refinement& refinement, const Monitor& monitor)
{
  constexpr double sweepFrom = 0.99;
  if (input.HasReachedFaces())
  {
    return true;
  }
  if (!input.MeshEditor.LimitsEdits() &&
    !refinement.CollapseTo(
      input.Stops.Faces, input.Mode.Refine.EdgesOfCollapse, PartOf(monitor, 0.0, sweepFrom)))
  {
    return false;
  }
  if (input.HasReachedFaces())
  {
    return monitor(1.0);
  }
  input.MeshEditor.PrepareCollapses(input.Threads);
  const Monitor last = PartOf(monitor, sweepFrom, 1.0);
  const Monitor still = [&last](double) { return last(0.0); };
  return SweepTo(input, input.Stops.Faces, still) != StopReason::Aborted && refinement.Begin(last);
}

/// Improves shapes if this is requested. False if the monitor requests a stop.
bool ShapeBetween(const StageInput& input, Refinement& refinement, const Monitor& monitor)
{
  constexpr double shapedAt = 0.8;
  return !input.ImprovesShape() ||
    (ImproveShape(input, PartOf(monitor, 0.0, shapedAt)) &&
      refinement.Begin(PartOf(monitor, shapedAt, 1.0)));
}

/// Refines without an error bound. False if the monitor requests a stop.
bool RefineAndCollapse(const StageInput& input, Refinement& refinement, const Monitor& monitor)
{
  constexpr double begunAt = 0.3;
  constexpr double sweptAt = 0.3; // of a round
  constexpr double shapedAt = 0.4;
  const RefineSettings& settings = input.Mode.Refine;
  const int rounds = input.MeshEditor.LimitsEdits() ? settings.VoxelRounds : 1;
  const Monitor tell = PartOf(monitor, begunAt, 1.0);
  bool shouldContinue = refinement.Begin(PartOf(monitor, 0.0, begunAt));
  for (int i = 0; i < rounds && shouldContinue; ++i)
  {
    const Monitor round = StepOf(tell, i, rounds);
    shouldContinue = refinement.Sweep(settings.SweepsBefore, PartOf(round, 0.0, sweptAt)) &&
      ShapeBetween(input, refinement, PartOf(round, sweptAt, shapedAt)) &&
      CollapseLast(input, refinement, PartOf(round, shapedAt, 1.0));
  }
  return shouldContinue;
}

/// The number of rounds of the mode that the options request.
int RoundsOf(const StageInput& input, int rounds)
{
  return static_cast<int>(std::lround(input.RefinementEffort * rounds));
}

/// Alternates moves that leave more of the error bound and collapses that use it. False if the
/// monitor requests a stop.
bool CollapseBySlack(const StageInput& input, SlackRefinement& slack, const Monitor& monitor)
{
  constexpr double sweptAt = 0.6; // of a round
  const int rounds = RoundsOf(input, input.Mode.Refine.ProvedRounds);
  bool shouldContinue = true;
  for (int i = 0; i < rounds && shouldContinue && !input.HasReachedFaces(); ++i)
  {
    const Monitor round = StepOf(monitor, i, rounds);
    shouldContinue = slack.Sweep(input.Mode.Refine.ProvedSweeps, PartOf(round, 0.0, sweptAt)) &&
      slack.Collapse(input.Stops.Faces, PartOf(round, sweptAt, 1.0));
  }
  return shouldContinue;
}

/// Forces collapses that exceed the error bound before vertices around them move, in the first
/// round by little. Where a round succeeded in most of its attempts, the surface is smooth, and the
/// next round reaches farther. Rounds continue while each removes at least one face in this many.
/// False if the monitor requests a stop.
bool ForceCollapses(const StageInput& input, SlackRefinement& slack, const Monitor& monitor)
{
  constexpr ForcedReach first = { 1.25, 1 };
  constexpr ForcedReach usual = { 1.4, 1 };
  constexpr ForcedReach wide = { 1.6, 2 };
  constexpr std::int64_t maxTriedPerMade = 3; // for a wide reach
  constexpr Index facesPerRemoved = 64;
  constexpr double forcedAt = 0.8; // of a round
  const HalfEdgeMesh& mesh = input.MeshEditor.Mesh();
  const int rounds = RoundsOf(input, input.Mode.Refine.ForcedRounds);
  ForcedCollapseFigures figures;
  ForcedReach reach = first;
  bool shouldContinue = true;
  bool isWorthIt = true;
  for (int i = 0; i < rounds && shouldContinue && isWorthIt && !input.HasReachedFaces(); ++i)
  {
    const Index before = mesh.NumberOfFaces();
    const Monitor round = StepOf(monitor, i, rounds);
    const ForcedCollapseFigures known = figures;
    shouldContinue = slack.Force(input.Stops.Faces, reach, PartOf(round, 0.0, forcedAt), figures) &&
      slack.Sweep(1, PartOf(round, forcedAt, 1.0));
    reach =
      figures.Tried - known.Tried <= maxTriedPerMade * (figures.Made - known.Made) ? wide : usual;
    isWorthIt = i == 0 || before - mesh.NumberOfFaces() >= before / facesPerRemoved;
  }
  if (input.Forced != nullptr)
  {
    *input.Forced = figures;
  }
  return shouldContinue;
}

/// Refines within an error bound. False if the monitor requests a stop.
bool RefineWithinBound(const StageInput& input, Refinement& refinement, const Monitor& monitor)
{
  constexpr double begunAt = 0.05;
  constexpr double collapsedAt = 0.4;
  constexpr double forcedAt = 0.5;
  constexpr double shapedAt = 0.65;
  constexpr double refinedAt = 0.95;
  const bool usesSlack =
    !input.HasReachedFaces() && RoundsOf(input, input.Mode.Refine.ProvedRounds) > 0;
  SlackRefinement slack(input.MeshEditor, input.Threads);
  return (!usesSlack ||
           (slack.Begin(PartOf(monitor, 0.0, begunAt)) &&
             CollapseBySlack(input, slack, PartOf(monitor, begunAt, collapsedAt)) &&
             ForceCollapses(input, slack, PartOf(monitor, collapsedAt, forcedAt)))) &&
    ImproveShape(input, PartOf(monitor, forcedAt, shapedAt)) &&
    // Collapses and splits for the shape changed faces to which samples belong.
    (!usesSlack || !input.ImprovesShape() || slack.Begin(PartOf(monitor, shapedAt, shapedAt))) &&
    refinement.Begin(PartOf(monitor, shapedAt, shapedAt + begunAt)) &&
    refinement.Sweep(
      input.Mode.Refine.ProvedSweepsAfter, PartOf(monitor, shapedAt + begunAt, refinedAt)) &&
    (!usesSlack || slack.RestoreVolume(PartOf(monitor, refinedAt, 1.0)));
}

/// False if the monitor requests a stop.
bool Refine(const StageInput& input, const Monitor& monitor)
{
  constexpr double collapsedAt = 0.7;
  const RefineSettings& settings = input.Mode.Refine;
  Refinement refinement(input.MeshEditor, *input.InitialMesh, settings.ShapeWeight, input.Threads);
  if (input.MeshEditor.Bound() != nullptr)
  {
    return RefineWithinBound(input, refinement, monitor);
  }
  const bool fewRemain = input.Stops.Faces < FewTriangles * input.InitialFaces;
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
  return ReasonToStop(input);
}
}
