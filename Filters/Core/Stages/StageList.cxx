// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StageList.h"

#include "HandleLimit.h"

namespace bonedecimate
{
StopReason RunStages(StageInput input, const Monitor& monitor)
{
  const StopCriterion stop(input.MeshEditor, input.Stops);
  if (stop.IsReached())
  {
    return stop.Reason();
  }
  input.FacesAtStart = input.MeshEditor.Mesh().NumberOfFaces();
  input.InitialMesh = input.Mode.KeepsInitialMesh ? &input.MeshEditor.InitialMesh() : nullptr;
  StopReason reason = StopReason::NotRun;
  double begin = 0.0;
  for (const Stage& stage : input.Mode.Stages)
  {
    reason = stage.Run(input, PartOf(monitor, begin, stage.End));
    if (reason == StopReason::Aborted)
    {
      break;
    }
    begin = stage.End;
  }
  const bool isShort =
    input.Stops.Faces > 0 && input.MeshEditor.Mesh().NumberOfFaces() > input.Stops.Faces;
  return reason == StopReason::NothingLeft && isShort && AreHandlesInTheWay(input.MeshEditor)
    ? StopReason::Handles
    : reason;
}
}
