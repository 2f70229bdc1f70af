// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CollapseSearch.h
 * @brief Searches the cheapest collapse at a vertex that rules and filters accept. Changes neither
 * the mesh nor the buckets.
 *
 *     an edge leads out of the block:       deferred
 *     for every edge up to the highest cost, cheapest first:
 *         rejected before, and unchanged:   skip it
 *         accepted:                         return it
 *         rejected, or its spike penalty is above the highest cost:
 *                                           next edge; after the last one, raise the bucket by a
 *                                           factor of 16 in cost
 *         not proved, or intersecting:      next edge, if all are tried; after the last one, wait
 *                                           for the next pass
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_CollapseSearch_h
#define BoneDecimate_Core_Decimate_Schedule_CollapseSearch_h

#include "Decimate/Edit/Editor.h"
#include "VertexEdges.h"

namespace bonedecimate
{
struct BlockTask
{
  VertexRange Vertices;
  CostBucket Limit = LastBucket; ///< Vertices above it are not collapsed.
  Index Collapses = 0;           ///< Maximum number.
  int Workers = 1;               ///< Blocks that are swept at the same time.
  bool RenewsRing = false;       ///< Computes the buckets of the ring of a merged vertex again.
  /// Positions tried for a merged vertex until one can be proved. 1: only the best position, and no
  /// other edge.
  int PositionsTried = 1;
  bool TriesAll() const { return this->PositionsTried > 1; }
};

class CollapseSearch
{
public:
  enum class Outcome
  {
    Accepted,
    Rejected, ///< The vertex gets another bucket.
    Deferred
  };
  struct Result
  {
    Outcome Kind = Outcome::Rejected;
    CostBucket Bucket = NeverBucket; ///< Bucket of the vertex if it is rejected.
    double AccumulatedError = 0.0;   ///< That of an accepted merged vertex, units.
    bool IsLasting = true; ///< Whether a rejection holds until something near the vertex changes.
  };

  CollapseSearch(const Editor& editor, const SweepData& data)
    : MeshEditor(editor)
    , Data(data)
    , KernelSet(BestKernels())
  {
  }

  /// @param edges The edges of the vertex, evaluated if they are inside of the block; reset
  /// afterwards.
  /// @param workspace Receives an accepted collapse, for Editor::Apply. Its change has the range
  /// and the workers of the task.
  Result Find(
    VertexEdges& edges, CostBucket highest, const BlockTask& task, EditWorkspace& workspace);

private:
  enum class Trial
  {
    TooCostly,
    Crossing, ///< Rejected by the intersection guard; waits for the next pass.
    TooFar,   ///< Not proved; waits until something near it changes.
    Accepted,
    Deferred
  };
  bool WasTried(VertexId vertex) const;
  Trial TryEdge(VertexId vertex, const VertexEdges::Candidate& candidate, float maxCost);
  Trial TryPositions(const Edit& best, float maxCost);
  Edit EditOf(VertexId vertex, const VertexEdges::Candidate& candidate) const;
  double AccumulatedErrorAfter(const Edit& edit);

  const Editor& MeshEditor;
  const SweepData& Data;
  const Kernels& KernelSet;
  const BlockTask* Task = nullptr; // of the current search, like all that follows
  EditWorkspace* Workspace = nullptr;
  double AccumulatedError = 0.0; // units, of the position tried last
  bool IsLasting = true;         // of the rejections so far
};
}

#endif
