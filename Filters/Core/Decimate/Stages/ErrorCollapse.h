// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorCollapse.h
 * @brief The last collapses, in the order of their change of the sampled two-sided error.
 *
 *     evaluate the cheapest inside edges by their quadrics, several for each remaining collapse
 *       (FanFit)
 *     limit = the cost with no more edges below it than collapses remain
 *     every block of consecutive vertices, on any thread, then every block half a block further:
 *         collapse its edges below the limit, cheapest first, at most as many as lay below it
 *           (ErrorQueue)
 *     on one thread:  collapse what is left, cheapest first, down to the exact number
 *
 * Limit, blocks and allowances depend on the mesh alone, so that the number of threads does not
 * change the result. Edges at open boundaries and constrained parts are left to the other order.
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
  /// @param editor Must keep quadrics, and they must be right.
  /// @param edgesOfCollapse Number of edges first evaluated for each remaining collapse.
  ErrorCollapse(
    Editor& editor, Samples& samples, OriginalHints& hints, int edgesOfCollapse, int threads);

  /// Down to that many faces, or until no edge may be collapsed. False if the monitor requests a
  /// stop.
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
  Index TargetFaces = 0;            // faces
  float MaxQuadricCost = 0.0F;      // by quadrics, of the evaluated edges
  std::vector<EvaluatedEdge> Edges; // waiting
};
}

#endif
