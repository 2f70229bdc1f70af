// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CollapseStage.h"

#include "Decimate/Schedule/BucketSweep.h"
#include "FeatureCurveStages.h"
#include "ThesisCollapse.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// The number of faces at which the sweep ends.
Index FacesOfSweep(const StageInput& input)
{
  const RefineSettings& refine = input.Mode.Refine;
  const double extra =
    std::min(refine.ExtraOfTarget * input.Stops.Faces, refine.ExtraOfOriginal * input.InitialFaces);
  return std::min(input.InitialFaces, input.Stops.Faces + static_cast<Index>(extra));
}

StopReason CollapseByQueue(
  const StageInput& input, const QueuePolicies& policies, const Monitor& monitor)
{
  ThesisCollapse queue(input.MeshEditor, policies, input.NormalTolerance);
  FeatureCurveStages stages(input.MeshEditor, input.Stops, monitor);
  while (stages.Next())
  {
    stages.NoteEnd(queue.Run(stages.Targets(), stages.Progress()));
  }
  return stages.Reason();
}
}

StopReason CollapseStage(const StageInput& input, const Monitor& monitor)
{
  const auto* queue = std::get_if<QueuePolicies>(&input.Mode.Schedule);
  return queue != nullptr ? CollapseByQueue(input, *queue, monitor)
                          : SweepTo(input, FacesOfSweep(input), monitor);
}

//------------------------------------------------------------------------------
StopReason SweepTo(const StageInput& input, Index faces, const Monitor& monitor)
{
  BucketSweep sweep(input.MeshEditor, input.Threads, input.Mode.Sweep,
    std::get<SweepPolicies>(input.Mode.Schedule));
  FeatureCurveStages stages(input.MeshEditor, { faces, input.Stops.Error }, monitor);
  while (stages.Next())
  {
    stages.NoteEnd(sweep.Run(stages.Targets(), stages.Progress()));
  }
  return stages.Reason();
}
}
