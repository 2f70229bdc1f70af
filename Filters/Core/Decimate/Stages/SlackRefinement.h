// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlackRefinement.h
 * @brief Fewer triangles within an error bound: moves that leave more of the bound, and collapses
 * that use it up.
 *
 *     Begin:      distribute samples of the original over the faces, the original that the bound
 *                 refers to
 *     Sweep:      flip edges                                                         (SlackFlipper)
 *                 color the vertices; of each color evaluate all moves in parallel, then apply them
 *                   on one thread   (SlackMover)
 *     Collapse:   the same in rounds, the collapses that leave most of the bound first
 *       (SlackCollapse)
 *
 *     Force:      collapses that keep the bound only with moves and flips around them
 *       (ForcedCollapse)
 *     RestoreVolume:   moves that give lost volume back                               (VolumeMover)
 *
 * Every edit is proved as any other; samples only propose.
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
  /// Down to that many faces at most.
  bool Collapse(Index faces, const Monitor& monitor);
  /// Also where moves and flips around the collapse are needed.
  /// @param figures What was tried and made is added to them.
  bool Force(
    Index faces, ForcedReach reach, const Monitor& monitor, ForcedCollapseFigures& figures);
  /// Moves that give components the volume back that they have lost. Flips and moves by others may
  /// come before, collapses may not.
  bool RestoreVolume(const Monitor& monitor);

private:
  bool MoveVertices(const Monitor& monitor);
  bool MoveAll(const std::vector<Index>& vertices, const Monitor& monitor);
  std::vector<std::vector<Index>> ColorVertices() const;
};
}

#endif
