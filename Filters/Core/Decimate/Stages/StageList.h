// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StageList.h
 * @brief Runs the stages of a mode over one mesh editor, in order.
 *
 *     the targets hold already:     nothing
 *     for each stage of the mode:   run it; the reason of the last stage is that of the run
 *     aborted:                      no further stage
 *
 * A stage is a function of StageInput (Options/Modes.h) in a file of its own. It leaves a valid
 * mesh, aborted or not.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_StageList_h
#define BoneDecimate_Core_Decimate_Stages_StageList_h

#include "Base/Monitor.h"
#include "Decimate/Edit/Editor.h"
#include "Decimate/Schedule/StopCriterion.h"
#include "Options/Modes.h"

namespace bonedecimate
{
/// The data that every stage of a run works on.
struct StageInput
{
  Editor& MeshEditor; ///< Keeps areas and quadrics as ModeInfo requires.
  const ModeInfo& Mode;
  StopTargets Stops;
  double NormalTolerance = 0.0; ///< w of Decimate/Cost/NormalFieldDeviation.h.
  int Threads = 1;              ///< 0: one per processor.
  Index InitialFaces = 0;       ///< Before the first stage; filled by RunStages().
  /// The mesh before the first edit if ModeInfo::KeepsInitialMesh; filled by RunStages().
  const HalfEdgeMesh* InitialMesh = nullptr;
  double RefinementEffort = 1.0; ///< As in the options.
  ShapeLimits Shape = {};        ///< Limits of triangles.
  /// Receives counts of forced collapses; null: not recorded.
  ForcedCollapseFigures* Forced = nullptr;

  bool ImprovesShape() const { return this->Shape.IsLimited(); }
  bool HasReachedFaces() const;
};

/// The reason of a stage that has done all it could.
StopReason ReasonToStop(const StageInput& input);

/// @param monitor Fractions from 0 to 1; not empty.
StopReason RunStages(StageInput input, const Monitor& monitor);
}

#endif
