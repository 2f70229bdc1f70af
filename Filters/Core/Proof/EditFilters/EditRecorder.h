// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditRecorder.h
 * @brief Records the log of a run in an order that does not depend on the threads.
 *
 * Each worker lists its collapses. The lists of parallel workers are merged as if one worker had
 * taken the cheapest edit first: by the largest rank so far in each list, then by list. Parallel
 * workers have no vertex in common, so any order that preserves the order in each list is valid.
 *
 * A patch stores the combined changes of many flips and moves: no level ends between them. A
 * collapse with moves of nearby vertices adds a patch, too.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_EditRecorder_h
#define BoneDecimate_Core_Proof_EditFilters_EditRecorder_h

#include "EditFilter.h"
#include "Levels/EditLog.h"

namespace bonedecimate
{
/// Accepts every edit. Flips and moves are recorded by BeginPatch and EndPatch.
class EditRecorder : public EditFilter
{
public:
  void Commit(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& pending, Tally& tally) override;
  void Settle(Tally* tallies, std::size_t count) override;

  /// To be called before and after a sequence of flips and moves.
  void BeginPatch(const HalfEdgeMesh& mesh);
  void EndPatch(const HalfEdgeMesh& mesh);

  /// Adds the vertices that move with the last settled collapse, and the faces that differ from
  /// those of the collapse alone.
  void AddNearby(
    const std::vector<VertexMove>& moves, const std::vector<SurfaceChange::Face>& faces);

  /// The log, with positions in mm from the local origin.
  EditLog Take() { return std::move(this->Log); }

private:
  void Add(std::vector<LoggedCollapse>& collapses);
  void AddMerged(Tally* tallies, std::size_t count);

  EditLog Log;
  std::vector<Triangle> CornersBefore;
  std::vector<Vector3> PositionsBefore; // mm
};
}

#endif
