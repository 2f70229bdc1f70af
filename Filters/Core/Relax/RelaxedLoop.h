// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RelaxedLoop.h
 * @brief The loop of Balanced and Accurate: Fast nearly to the end, then with samples of the original in hand.
 *
 *     Sweep to a few faces more than wanted                (ordered by what collapses do to the normals)
 *     give every face the samples of the original near it
 *     flip edges and move vertices
 *     collapse the rest by what that does to the sampled error
 *     flip edges and move vertices again
 *
 * Where every edit is proved nobody knows the last collapses beforehand: then the sweep goes all the way, and flips and
 * moves are proved like collapses. They make room for further ones: another sweep follows, and both once more as often as the
 * recipe says.
 */
#ifndef BoneDecimate_Core_Relax_RelaxedLoop_h
#define BoneDecimate_Core_Relax_RelaxedLoop_h

#include "Collapse/BlockSweep.h"
#include "Relaxation.h"

namespace bonedecimate
{
/// How much is done beyond the sweep.
struct Recipe
{
  double ExtraOfWanted;   ///< The sweep stops that share of the wanted faces early,
  double ExtraOfOriginal; ///< but not earlier than that share of the original ones.
  int EdgesOfCollapse;    ///< Edges judged for each of the last collapses.
  int SweepsBefore;       ///< Relaxation before the last collapses.
  int SweepsAfter;        ///< And after them,
  int SweepsIfFew;        ///< or where few triangles remain and sweeps cost little.
  int PlacesTried;        ///< Where edits are proved: of BlockTask,
  int ProvedRounds;       ///< and how often relaxation and a sweep follow each other.
};
constexpr Recipe BalancedRecipe = { 0.2, 0.02, 4, 1, 1, 3, 8, 1 };
constexpr Recipe AccurateRecipe = { 0.3, 0.06, 4, 1, 6, 8, BlockTask::MostPlaces, 3 };

class RelaxedLoop
{
public:
  /// @param editor Must keep quadrics.
  RelaxedLoop(Editor& editor, const Recipe& recipe, const Stops& stops, int threads);

  /// @param monitor Hears fractions from 0 to 1.
  StopReason Run(const Monitor& monitor);

private:
  StopReason Collapse(Index faces, const Monitor& monitor);
  bool Relax(const HalfEdgeMesh& original, const Monitor& monitor);
  bool CollapseLast(Relaxation& relaxation, const Monitor& monitor);
  Index FacesOfSweep() const;

  Editor& Work;
  Recipe Asked;
  Stops Wanted;
  int Threads;
  Index FacesAtFirst;
};
}

#endif
