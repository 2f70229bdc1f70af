// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BucketSweep.h
 * @brief Collapses ordered by the change of the normal field, in rounds of blocks that are swept in
 * parallel.
 *
 * Without an error bound or voxels:
 *
 *     compute the buckets of all vertices
 *     limit = the highest bucket with no more vertices up to it than collapses remain
 *     a round, while many collapses remain:
 *         sweep blocks of consecutive vertices up to the limit, then blocks shifted by half;
 *             each may collapse in proportion to its vertices up to the limit
 *         sweep the whole mesh as one block up to the limit, for edges between blocks
 *         raise the limit: after the first round by a factor of 4 in cost, later by as many
 *             buckets as should give 0.7 of the remaining collapses (RoundFraction), by the
 *             collapses per bucket of the last round
 *     the tail: sweep the whole mesh as one block, without a limit, to the exact number
 *     repeat if the target is not reached, unless nothing was collapsed
 *
 * If every edit is proved, the final number of faces is not known in advance:
 *
 *     draft:    like pass 0, in rounds, proved together at the end (Decimate/Edit/Draft.h); once
 *               per editor. The limit starts at half of the vertices and rises by a factor of 16
 *               in cost; a round also sweeps three large blocks, for edges between the others
 *     pass 0:   sweep the whole mesh in batches (BatchSweep), because proofs take most of the
 *               time. One edge per vertex, best position only; edges that cannot be proved wait
 *               for the next pass
 *     pass 1 and later: the same, with buckets computed only near changes, and with all edges of
 *               a vertex, each with the best position, its middle, its ends, and others near
 *               the best
 *     end:      a pass removes less than one face in 128 (MinOfPass), or the target is reached
 *
 * If voxels alone limit the edits, passes are rounds like those of the draft, because their checks
 * are short.
 *
 * Limits, blocks and allowances are set before a pass over the blocks and depend on the mesh alone,
 * so the number of threads does not change the result. No round aims beyond the final limit: this
 * would be faster but cost several percent of accuracy. Small meshes have only the tail. Below a
 * fiftieth of the faces, the tail computes the buckets of whole rings again after each collapse.
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_BucketSweep_h
#define BoneDecimate_Core_Decimate_Schedule_BucketSweep_h

#include "BlockSweep.h"
#include "Decimate/Cost/QuadricDeviation.h"
#include "Decimate/Kernels/EdgeEvaluator.h"
#include "Decimate/Placement/VolumePreserving.h"
#include "Options/Modes.h"
#include "StopCriterion.h"

namespace bonedecimate
{
class BucketSweep
{
public:
  /// @param editor Must keep quadrics.
  BucketSweep(Editor& editor, int threads, const SweepSettings& settings = {},
    const SweepPolicies& policies = { QuadricDeviation, VolumePreservingPosition });

  /// May run again with other targets after other stages have changed the mesh.
  /// @param monitor Receives fractions from 0 to 1.
  StopReason Run(const StopTargets& stops, const Monitor& monitor);

private:
  static constexpr int MaxStep = 4 * BucketsPerDoubling; ///< Maximum rise of a limit.

  bool RenewAll(const Monitor& monitor);
  Index RemainingCollapses() const;
  StopReason RunProved(const Monitor& monitor);
  bool MakeDraft(const Monitor& monitor);
  bool PassInRounds(const Monitor& monitor);
  bool HasRounds() const;
  bool RunRounds(const Monitor& monitor);
  CostBucket FirstLimit(Index collapses) const;
  bool Round(CostBucket limit, const Monitor& monitor);
  struct BlockCut
  {
    Index Size;     ///< Vertex slots of a block.
    bool IsShifted; ///< By half of a block.
  };
  bool SweepBlocks(CostBucket limit, BlockCut cut, const Monitor& monitor);
  Index BlockSize() const;
  BlockCut LargeBlocks() const;
  std::vector<BlockTask> Blocks(CostBucket limit, BlockCut cut) const;
  BlockTask WholeTask(CostBucket limit, Index faces) const;
  bool Tail(const Monitor& monitor);
  bool SweepWhole(CostBucket limit, Index faces, bool renewsRing, const Monitor& monitor);

  Editor& MeshEditor;
  StopTargets Targets;
  StopCriterion End;
  int Threads;
  SweepData Data;
  Index InitialFaces;
  int PositionsTried;
  EdgeEvaluator Evaluate;
  bool TriesAll = false; // all edges and positions, or only the best
};
}

#endif
