// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeStage.h"

#include "CollapseStage.h"
#include "EdgeSizer.h"
#include "ShapeImprover.h"

namespace bonedecimate
{
namespace
{
/// Collapses once more: larger angles allow collapses that were rejected. False if the monitor
/// requests a stop.
bool CollapseOnce(const StageInput& input, const Monitor& monitor)
{
  input.MeshEditor.PrepareCollapses(input.Threads);
  return input.HasReachedFaces() ||
    SweepTo(input, input.Stops.Faces, monitor) != StopReason::Aborted;
}

/// Enlarges angles. If no edge length is requested, this collapses edges of any length. False if
/// the monitor requests a stop.
bool EnlargeAngles(const StageInput& input, const Monitor& monitor)
{
  constexpr double mendedAt = 0.2;
  constexpr double sweptAt = 0.4;
  constexpr double collapsedAt = 0.8; // of a round
  constexpr int maxRounds = 12;
  // no further round after one that removes less than one face in this many
  constexpr Index facesPerRemoved = 128;
  const HalfEdgeMesh& mesh = input.MeshEditor.Mesh();
  ShapeImprover improver(input.MeshEditor, input.Shape.MaxCosine);
  bool shouldContinue = improver.Mend(PartOf(monitor, 0.0, mendedAt));
  if (!input.MeshEditor.LimitsEdits() || input.Shape.LimitsEdges())
  {
    return shouldContinue;
  }
  shouldContinue = shouldContinue && CollapseOnce(input, PartOf(monitor, mendedAt, sweptAt));
  const Monitor rounds = PartOf(monitor, sweptAt, 1.0);
  bool isWorthIt = true;
  for (int i = 0; i < maxRounds && shouldContinue && isWorthIt && !input.HasReachedFaces(); ++i)
  {
    const Index before = mesh.NumberOfFaces();
    const Monitor round = StepOf(rounds, i, maxRounds);
    shouldContinue = improver.Collapse(input.Stops.Faces, PartOf(round, 0.0, collapsedAt)) &&
      improver.Mend(PartOf(round, collapsedAt, 1.0));
    isWorthIt = before - mesh.NumberOfFaces() >= before / facesPerRemoved;
  }
  return shouldContinue && monitor(1.0);
}
}

bool ImproveShape(const StageInput& input, const Monitor& monitor)
{
  if (!input.ImprovesShape())
  {
    return true;
  }
  const double sizedAt = !input.Shape.LimitsEdges() ? 0.0 : input.Shape.LimitsAngles() ? 0.5 : 1.0;
  return (!input.Shape.LimitsEdges() ||
           EdgeSizer(input.MeshEditor, input.Shape, input.Threads)
             .Run(input.Stops.Faces, PartOf(monitor, 0.0, sizedAt))) &&
    (!input.Shape.LimitsAngles() || EnlargeAngles(input, PartOf(monitor, sizedAt, 1.0)));
}
}
