// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StopCriterion.h
 * @brief Stop targets of a loop, its progress, and progress reports to a monitor.
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_StopCriterion_h
#define BoneDecimate_Core_Decimate_Schedule_StopCriterion_h

#include "Base/Monitor.h"
#include "Decimate/Edit/Editor.h"

namespace bonedecimate
{
struct StopTargets
{
  Index Faces = 0; ///< Number of triangles to reach.
  /// mm, only in modes that stop at a recorded error: the distance of a new vertex to the original
  /// that must also be reached; 0: none.
  double Error = 0.0;
};

/// The targets that the options define for a surface of that many faces. A default reduction is
/// ignored if there is any other target. In modes that prove the largest error, that error is no
/// stop target: edits beyond it are rejected.
/// @param isLimited Whether every point has a tolerance, which counts as another target.
StopTargets StopTargetsOf(const Options& options, Index faces, bool isLimited = false);

class StopCriterion
{
public:
  StopCriterion(const Editor& editor, const StopTargets& stops);

  /// Restarts from the current mesh with other targets.
  void Restart(const StopTargets& stops);

  bool IsReached() const;

  /// Why it is reached, while IsReached().
  StopReason Reason() const;

  /// Reports to the monitor every half percent; ReportNow reports at once. False if the monitor
  /// requests a stop.
  bool Report(const Monitor& monitor);
  /// @param unsettled Faces that workers have removed and the mesh has not counted yet.
  bool ReportNow(const Monitor& monitor, Index unsettled = 0);

private:
  bool ErrorIsReached() const;
  double FractionDone(Index unsettled) const;

  const Editor& MeshEditor;
  StopTargets Targets;
  Index InitialFaces;
  double Reported = 0.0;
};
}

#endif
