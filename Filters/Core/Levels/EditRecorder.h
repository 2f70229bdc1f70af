// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditRecorder.h
 * @brief Writes the log of a run down while it runs, in an order that does not depend on the threads.
 *
 * Workers list their collapses; what those that worked side by side listed is put in one order, as if one worker had
 * taken the cheapest of all: by the largest rank so far in each list, then list by list. They touched no vertex in common,
 * so any order that keeps each list's own is one in which the run could have gone.
 *
 * Flips and moves are many, and nobody stops between them: a patch holds what they changed altogether.
 */
#ifndef BoneDecimate_Core_Levels_EditRecorder_h
#define BoneDecimate_Core_Levels_EditRecorder_h

#include "EditLog.h"
#include "Mesh/HalfEdgeMesh.h"

namespace bonedecimate
{
class EditRecorder
{
public:
  /// What one worker listed; the list is empty afterwards.
  void Add(std::vector<LoggedCollapse>& collapses);
  /// What workers listed that worked side by side; the lists are empty afterwards.
  void AddMerged(const std::vector<std::vector<LoggedCollapse>*>& lists);

  /// Before and after flips and moves.
  void BeginPatch(const HalfEdgeMesh& mesh);
  void EndPatch(const HalfEdgeMesh& mesh);

  /// Positions are in mm from the local origin.
  EditLog Take() { return std::move(this->Log); }

private:
  EditLog Log;
  std::vector<Triangle> CornersBefore;
  std::vector<Vector3> PositionsBefore; // mm
};
}

#endif
