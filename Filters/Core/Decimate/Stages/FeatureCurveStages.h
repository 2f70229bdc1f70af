// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FeatureCurveStages.h
 * @brief Divides a run into stages, and simplifies the curves along which patches meet before each
 * stage.
 *
 *     FeatureCurveStages stages(editor, stops, monitor)
 *     while (stages.Next())
 *         stages.NoteEnd(run to stages.Targets() with stages.Progress())
 *
 *     no curves: one stage
 *     a stage:   faces = a quarter of the faces, or the target if this is more
 *                simplify the curves to edges in proportion to the square root of the faces,
 *                  with a deviation up to half of the mean edge, so that curves and surface
 *                  have a similar resolution
 *                run down to the faces of the stage
 *     the run is stuck:  continue with coarser curves until they are stuck, too
 *
 * If edits are proved, edits beyond the error bound are rejected as well.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_FeatureCurveStages_h
#define BoneDecimate_Core_Decimate_Stages_FeatureCurveStages_h

#include "Decimate/Schedule/StopCriterion.h"
#include "FeatureCurveCollapse.h"

#include <optional>

namespace bonedecimate
{
class FeatureCurveStages
{
public:
  /// @param monitor Must outlive this.
  FeatureCurveStages(Editor& editor, const StopTargets& stops, const Monitor& monitor);

  /// Simplifies the curves for the next stage. False if there is no next stage or the monitor
  /// requests a stop.
  bool Next();
  const StopTargets& Targets() const { return this->StageTargets; }
  /// Maps fractions of the stage to fractions of the run.
  const Monitor& Progress() const { return this->StageMonitor; }
  /// Tells why the run of the stage ended.
  void NoteEnd(StopReason reason);
  StopReason Reason() const { return this->LastReason; }

private:
  double RatioOf(Index faces) const;
  Index FacesOfStageAt(double ratio) const;
  FeatureCurveCollapse::Result CollapseFeatureCurves(Index faces);
  double FractionAt(Index faces) const;
  void BeginStage(Index faces);

  Editor& MeshEditor;
  StopTargets RunTargets;
  StopTargets StageTargets;
  const Monitor& RunMonitor;
  Monitor StageMonitor;
  std::optional<FeatureCurveCollapse> FeatureCurves; // only if there are curves
  Index InitialFaces;
  double Ratio;              // faces of the stage to initial faces
  Index RemovedVertices = 0; // since the last stage
  double Reported = 0.0;
  bool ShouldContinue = true;
  bool IsStuck = false;
  bool CanCoarsen = false; // whether coarser curves may help if the run is stuck
  StopReason LastReason = StopReason::NothingLeft;
};
}

#endif
