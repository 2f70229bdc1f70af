// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BucketSweep.h
 * @brief Collapses ordered by what they do to the normal field, in rounds of blocks that are swept
 * at the same time.
 *
 *     compute the buckets of all vertices
 *     limit = the highest bucket with no more vertices at or below it than collapses remain
 *       (a histogram)
 *     while many collapses remain:                                                          a round
 *         sweep blocks of consecutive vertices up to the limit, then blocks shifted by half;
 *             the allowance of a block is in proportion to its vertices up to the limit
 *         sweep the whole mesh as one block up to the limit: edges whose ring left every block
 *         raise the limit by a factor of 4 in cost; from the second round on by as many buckets as
 *           should give 0.7
 *             (RoundFraction) of the remaining collapses, by the collapses per bucket of the last
 *               round
 *     sweep the whole mesh as one block, without a limit, down to the exact number         the tail
 *     target not reached:  repeat, unless nothing was collapsed since the buckets were computed
 *
 * If every edit is proved (ErrorBound), the final number of faces is not data in advance:
 *
 *     draft:    as pass 0, with edits that are proved together at its end (Decimate/Edit/Draft.h);
 *               once for an editor
 *               the limit starts at half of the vertices and rises by a factor of 16 in cost:  a
 *                 round each, as above
 *               between shifted blocks and the whole mesh, three large blocks; then the rest as one
 *                 block
 *     pass 0:   sweep the whole mesh in batches (BatchSweep), because a proof takes longer than
 *               anything else
 *               one edge of a vertex, best position only; edges that cannot be proved wait for the
 *                 next pass
 *     pass 1 and later:  such a sweep; buckets are computed only near changes
 *               all edges of a vertex, each with the best position, its middle, its ends, and
 *                 others near the best
 *     end:      a pass removes less than one face in 128 (MinOfPass), or the target is reached
 *
 * Where only voxels limit the edits, the passes are rounds as those of the draft, because these
 * checks are short.
 *
 * Limits, blocks and allowances are set before a pass over the blocks and depend on the mesh alone,
 * so that the number of threads does not change the result. No round aims beyond the final limit:
 * that would be faster but cost several percent of accuracy. Small meshes have no rounds, only the
 * tail. Below a fiftieth of the faces, the tail computes the buckets of whole rings again after
 * each collapse.
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

  /// May run again with other targets, after other stages have changed the mesh.
  /// @param monitor Receives fractions from 0 to 1.
  StopReason Run(const StopTargets& stops, const Monitor& monitor);

private:
  static constexpr int MaxStep = 4 * BucketsPerDoubling; ///< By which a limit is raised.

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
    bool IsShifted; ///< By half of one.
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
  bool TriesAll = false; // otherwise only the best position
};
}

#endif
