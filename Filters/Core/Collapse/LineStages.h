// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LineStages.h
 * @brief A loop towards fewer faces, in stages, with the lines along which sheets meet made coarser before each.
 *
 *     no lines:  the loop at once
 *     stage:     a quarter of the faces, or what is wanted, if that is more
 *                the lines come down to edges in proportion to the square root of the faces, as long as their deviation stays
 *                    within half of the mean edge: so that they are neither finer nor coarser than what lies beside them
 *                the loop comes down to the faces of the stage
 *     the loop is stuck:  on with finer shares of the lines, until they are stuck, too
 *
 * Where edits are proved, what lies beyond the promise is refused besides.
 */
#ifndef BoneDecimate_Core_Collapse_LineStages_h
#define BoneDecimate_Core_Collapse_LineStages_h

#include "Goal.h"

#include <functional>

namespace bonedecimate
{
/// Runs towards the stops, hearing of fractions from 0 to 1.
using StagedLoop = std::function<StopReason(const Stops& stops, const Monitor& monitor)>;

StopReason RunInStages(
  Editor& editor, const Stops& stops, const Monitor& monitor, const StagedLoop& loop);
}

#endif
