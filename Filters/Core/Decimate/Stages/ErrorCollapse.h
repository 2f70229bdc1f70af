// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorCollapse.h
 * @brief The last collapses, in the order of their change of the sampled error in both directions.
 *
 *     evaluate the cheapest inner edges by quadrics, several per remaining collapse   (FanFit)
 *     limit = the cost with no more edges up to it than collapses remain
 *     in parallel, blocks of consecutive vertices, then blocks shifted by half:
 *         collapse edges up to the limit, cheapest first, no more than were below it  (ErrorQueue)
 *     on one thread:  collapse the rest, cheapest first, to the exact number
 *
 * Limit, blocks and allowances depend on the mesh alone, so the number of threads does not change
 * the result. Edges at open boundaries and constrained parts are left to BucketSweep.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_ErrorCollapse_h
#define BoneDecimate_Core_Decimate_Stages_ErrorCollapse_h

#include "ErrorQueue.h"

#include <vector>

namespace bonedecimate
{
class ErrorCollapse
{
public:
  /// @param editor Must keep quadrics, and they must be up to date.
  /// @param edgesOfCollapse Number of edges first evaluated per remaining collapse.
  ErrorCollapse(
    Editor& editor, Samples& samples, OriginalHints& hints, int edgesOfCollapse, int threads);

  /// Collapses down to that many faces, or until no edge can be collapsed. False if the monitor
  /// requests a stop.
  bool Run(Index faces, const Monitor& monitor);

private:
  bool EvaluateCheapest(std::size_t count, const Monitor& monitor);
  bool CollapseBlocks(const Monitor& monitor);
  bool CollapseRest(const Monitor& monitor);
  double LimitFor(std::size_t collapses) const;
  bool CollapseRound(Index size, Index shift, const Monitor& monitor);
  std::vector<ErrorBlock> Blocks(Index size, Index shift) const;
  std::size_t RemainingCollapses() const;

  Editor& MeshEditor;
  Samples& OriginalSamples;
  OriginalHints& Hints;
  SampledErrors Errors;
  std::size_t EdgesOfCollapse;
  int Threads;
  Index TargetFaces = 0;
  float MaxQuadricCost = 0.0F;      // largest of the evaluated edges, by quadrics
  std::vector<EvaluatedEdge> Edges; // not yet collapsed
};
}

#endif
