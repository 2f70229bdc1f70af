// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StopCriterion.h
 * @brief The stop targets of a loop, and its reports of progress to a monitor.
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
  /// The distance, mm, of a new vertex to the original that must be reached, too; 0: none. Only in
  /// modes that stop at a recorded error.
  double Error = 0.0;
};

/// The targets that the options define for a surface of that many faces. The default reduction is
/// ignored if there is any other target. In modes that prove the largest error, this error is no
/// target: edits beyond it are rejected.
/// @param isLimited Whether every point has a tolerance, which counts as a target.
StopTargets StopTargetsOf(const Options& options, Index faces, bool isLimited = false);

class StopCriterion
{
public:
  StopCriterion(const Editor& editor, const StopTargets& stops);

  /// Starts again from the current mesh, with other targets.
  void Restart(const StopTargets& stops);

  bool IsReached() const;

  /// The reason; only if IsReached().
  StopReason Reason() const;

  /// Reports to the monitor at every half percent; ReportNow() at every call. False if the monitor
  /// requests a stop.
  bool Report(const Monitor& monitor);
  /// @param unsettled Faces removed by workers that have not been settled.
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
