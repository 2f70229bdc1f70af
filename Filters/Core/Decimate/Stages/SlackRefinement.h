// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlackRefinement.h
 * @brief Fewer triangles within an error bound: moves that leave more of the bound, and collapses
 * that use it.
 *
 *     Begin:          distribute samples over the faces; the original is the one of the bound
 *     Sweep:          flip edges                                               (SlackFlipper)
 *                     color the vertices; for each color evaluate all moves in parallel, then
 *                     apply them on one thread                                 (SlackMover)
 *     Collapse:       rounds of collapses, those first that leave most of the bound
 *                                                                              (SlackCollapse)
 *     Force:          collapses that keep the bound only with moves and flips around them
 *                                                                              (ForcedCollapse)
 *     RestoreVolume:  moves that restore lost volume                           (VolumeMover)
 *
 * Every edit is proved like any other; samples only propose edits.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_SlackRefinement_h
#define BoneDecimate_Core_Decimate_Stages_SlackRefinement_h

#include "ForcedCollapse.h"
#include "SampledRefinement.h"

#include <vector>

namespace bonedecimate
{
class SlackRefinement : public SampledRefinement
{
public:
  /// @param editor Must have an error bound and keep quadrics.
  SlackRefinement(Editor& editor, int threads);

  /// False if the monitor requests a stop; the surface is valid then, too.
  bool Sweep(int times, const Monitor& monitor);
  /// Collapses down to that many faces at most.
  bool Collapse(Index faces, const Monitor& monitor);
  /// Forces collapses with moves and flips around them.
  /// @param figures The numbers of attempts and successes are added.
  bool Force(
    Index faces, ForcedReach reach, const Monitor& monitor, ForcedCollapseFigures& figures);
  /// Restores volume that components have lost. Since Begin(), others may have flipped and moved,
  /// but not collapsed.
  bool RestoreVolume(const Monitor& monitor);

private:
  bool MoveVertices(const Monitor& monitor);
  bool MoveAll(const std::vector<Index>& vertices, const Monitor& monitor);
  std::vector<std::vector<Index>> ColorVertices() const;
};
}

#endif
