// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sweep.h
 * @brief Collapses ordered by what they do to the normal field, in rounds of blocks that are swept at the same time.
 *
 *     while many collapses are still wanted:                                                     a round
 *         limit = the highest key such that no more vertices lie below it than collapses are wanted
 *         cut the vertices into blocks of consecutive ones, shifted by half a block every other round
 *         sweep every block up to the limit; it may collapse as many as it has vertices below it
 *     sweep the whole mesh as one block down to the exact number                                  the tail
 *     nothing ready: new keys for all, once more, unless nothing has been collapsed since
 *
 * Limits, blocks and allowances are fixed before a round and depend on the mesh alone, so that the number of threads
 * changes the time and not the result. No round aims past the limit where the final one will lie: that would be
 * cheaper and cost several percent of accuracy. An error to stop at needs the one true order: then there is only the tail.
 */
#ifndef BoneDecimate_Core_Collapse_Sweep_h
#define BoneDecimate_Core_Collapse_Sweep_h

#include "BlockSweep.h"

namespace bonedecimate
{
class Sweep
{
public:
  /// @param editor Must keep quadrics.
  Sweep(Editor& editor, const Stops& stops, int threads);

  /// @param monitor Hears fractions from 0 to 1.
  StopReason Run(const Monitor& monitor);

private:
  bool RenewAll(const Monitor& monitor);
  Index CollapsesWanted() const;
  bool RunRounds(const Monitor& monitor);
  CostKey FirstLimit() const;
  bool Round(CostKey limit, bool isShifted, const Monitor& monitor);
  Index BlockSize() const;
  std::vector<BlockTask> Blocks(CostKey limit, bool isShifted) const;
  bool Tail(const Monitor& monitor);
  bool SweepWhole(CostKey limit, Index faces, bool renewsRing, const Monitor& monitor);

  Editor& Work;
  Stops Wanted;
  Goal End;
  int Threads;
  VertexKeys Known;
  Index FacesAtFirst;
};
}

#endif
