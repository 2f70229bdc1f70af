// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorCollapse.h
 * @brief The last collapses, in the order of what they truly do to the sampled two-sided error.
 *
 *     of all edges inside, the cheapest by their quadrics, several for each collapse wanted:  judge them    (FanFit)
 *     limit = the cost such that no more edges lie below it than collapses are wanted
 *     every block of consecutive vertices, on any thread, then every block half a block further:
 *         collapse its edges below the limit, cheapest first, at most as many as lay below it           (ErrorQueue)
 *     on one thread:  collapse what is left, cheapest first, down to the exact number
 *
 * Limit, blocks and allowances depend on the mesh alone, so that the number of threads does not change the result.
 * Edges at open borders and locked parts are left to the other order.
 */
#ifndef BoneDecimate_Core_Relax_ErrorCollapse_h
#define BoneDecimate_Core_Relax_ErrorCollapse_h

#include "ErrorQueue.h"

#include <vector>

namespace bonedecimate
{
class ErrorCollapse
{
public:
  /// @param editor Must keep quadrics, and they must be right.
  /// @param edgesOfCollapse How many edges are judged at first for each collapse that is wanted.
  ErrorCollapse(
    Editor& editor, Samples& samples, BackHints& hints, int edgesOfCollapse, int threads);

  /// Down to that many faces, or until no edge may be collapsed. False if the monitor said stop.
  bool Run(Index faces, const Monitor& monitor);

private:
  bool JudgeCheapest(std::size_t count, const Monitor& monitor);
  bool CollapseBlocks(const Monitor& monitor);
  bool CollapseRest(const Monitor& monitor);
  double LimitFor(std::size_t collapses) const;
  bool CollapseRound(Index size, Index shift, const Monitor& monitor);
  std::vector<ErrorBlock> Blocks(Index size, Index shift) const;
  std::size_t CollapsesWanted() const;

  Editor& Work;
  Samples& Fit;
  BackHints& Back;
  SampledErrors Errors;
  std::size_t EdgesOfCollapse;
  int Threads;
  Index Wanted = 0;              // faces
  float Dearest = 0.0F;          // by quadrics, of the edges worth judging
  std::vector<JudgedEdge> Edges; // waiting
};
}

#endif
