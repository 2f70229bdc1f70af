// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StageList.h"

#include "HandleLimit.h"
#include "ShapeStage.h"

namespace bonedecimate
{
bool StageInput::HasReachedFaces() const
{
  return this->MeshEditor.Mesh().NumberOfFaces() <= this->Stops.Faces;
}

//------------------------------------------------------------------------------
StopReason ReasonToStop(const StageInput& input)
{
  const StopCriterion stop(input.MeshEditor, input.Stops);
  return stop.IsReached()                       ? stop.Reason()
    : input.MeshEditor.Totals().MetErrorBound() ? StopReason::ErrorReached
                                                : StopReason::NothingLeft;
}

//------------------------------------------------------------------------------
StopReason RunStages(StageInput input, const Monitor& monitor)
{
  const StopCriterion stop(input.MeshEditor, input.Stops);
  if (stop.IsReached())
  {
    return stop.Reason();
  }
  input.InitialFaces = input.MeshEditor.Mesh().NumberOfFaces();
  input.InitialMesh =
    input.Mode.KeepsInitialMesh ? &input.MeshEditor.Original().InitialMesh() : nullptr;
  StopReason reason = StopReason::NotRun;
  // Refinement stages improve shapes themselves.
  const bool improvesShape = input.ImprovesShape() && !input.Mode.Refines();
  const Monitor stages = PartOf(monitor, 0.0, improvesShape ? 0.3 : 1.0);
  double begin = 0.0;
  for (const Stage& stage : input.Mode.Stages)
  {
    reason = stage.Run(input, PartOf(stages, begin, stage.End));
    if (reason == StopReason::Aborted)
    {
      break;
    }
    begin = stage.End;
  }
  if (improvesShape && reason != StopReason::Aborted)
  {
    reason =
      ImproveShape(input, PartOf(monitor, 0.3, 1.0)) ? ReasonToStop(input) : StopReason::Aborted;
  }
  const bool isShort =
    input.Stops.Faces > 0 && input.MeshEditor.Mesh().NumberOfFaces() > input.Stops.Faces;
  return reason == StopReason::NothingLeft && isShort && AreHandlesInTheWay(input.MeshEditor)
    ? StopReason::Handles
    : reason;
}
}
