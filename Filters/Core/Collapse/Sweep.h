// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sweep.h
 * @brief Collapses ordered by what they do to the normal field, in rounds of blocks that are swept at the same time.
 *
 *     new keys for all vertices
 *     limit = the highest key such that no more vertices lie at or below it than collapses are wanted   (a histogram)
 *     while many collapses are still wanted:                                                             a round
 *         sweep blocks of consecutive vertices up to the limit, then blocks shifted by half;
 *             each may collapse in proportion to the vertices it has up to the limit
 *         sweep the whole mesh as one block up to the limit: what reached out of every block
 *         raise the limit by two octaves; from the second round on by as many keys as should bring 0.7 (ShareOfRound)
 *             of the collapses still wanted, judged by what the last round brought for each key
 *     sweep the whole mesh as one block, without a limit, down to the exact number                       the tail
 *     not there yet:  from the beginning, unless nothing has been collapsed since the keys were new
 *
 * Where every edit is proved (Guarantee), nobody knows beforehand where it will end:
 *
 *     pass 0:   the limit lies at half of the vertices, then rises by four octaves at a time:  a round each, as above
 *               one edge of a vertex at its best place; what cannot be proved waits for the next pass
 *               between shifted blocks and the whole mesh, three large blocks
 *     pass 1 and later:  such a round without a limit
 *               all edges of a vertex, each at its best place, in its middle, at its ends, and at others near the best
 *     after each pass what blocks left is swept as one block, and only vertices near a change get new keys
 *     end:      a pass takes away less than one face in 128 (LeastOfPass), or what is wanted is reached
 *
 * Limits, blocks and allowances are fixed before a pass over the blocks and depend on the mesh alone, so that the
 * number of threads changes the time and not the result. No round aims past the limit where the final one will lie:
 * that would be cheaper and cost several percent of accuracy. Small meshes are not worth rounds: then there is only the
 * tail. Its end, below a fiftieth of the faces, renews the keys of whole rings.
 */
#ifndef BoneDecimate_Core_Collapse_Sweep_h
#define BoneDecimate_Core_Collapse_Sweep_h

#include "BlockSweep.h"

namespace bonedecimate
{
class Sweep
{
public:
  /// What a peak weighs, see Sweep.cxx: a stricter sweep costs some average and gives a smaller maximum.
  static constexpr double PeakWeight = 0.3;

  /// Where edits are proved, of a merged vertex, see BlockSweep.cxx: more of them give fewer triangles and take longer.
  static constexpr int PlacesTried = 4;

  /// @param editor Must keep quadrics.
  Sweep(Editor& editor, const Stops& stops, int threads, double peakWeight = PeakWeight,
    int places = PlacesTried);

  /// @param monitor Hears fractions from 0 to 1.
  StopReason Run(const Monitor& monitor);
  /// Again, towards something else, after others have changed the mesh.
  StopReason RunTo(const Stops& stops, const Monitor& monitor);

private:
  bool RenewAll(const Monitor& monitor);
  Index CollapsesWanted() const;
  StopReason RunProved(const Monitor& monitor);
  bool ProvedPass(const Monitor& monitor);
  bool HasRounds() const;
  bool RunRounds(const Monitor& monitor);
  CostKey FirstLimit(Index collapses) const;
  bool Round(CostKey limit, const Monitor& monitor);
  struct BlockCut
  {
    Index Size;     ///< Of a block, vertex slots.
    bool IsShifted; ///< By half of one.
  };
  bool SweepBlocks(CostKey limit, BlockCut cut, const Monitor& monitor);
  Index BlockSize() const;
  BlockCut LargeBlocks() const;
  std::vector<BlockTask> Blocks(CostKey limit, BlockCut cut) const;
  bool Tail(const Monitor& monitor);
  bool SweepWhole(CostKey limit, Index faces, bool renewsRing, const Monitor& monitor);

  Editor& Work;
  Stops Wanted;
  Goal End;
  int Threads;
  VertexKeys Known;
  Index FacesAtFirst;
  int Places;
  bool TriesAll = false; // otherwise the best place alone
};
}

#endif
