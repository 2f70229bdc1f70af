// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FeatureCurveStages.h
 * @brief Runs a loop in stages and simplifies the curves along which patches meet before each
 * stage.
 *
 *     no curves: the loop at once
 *     stage:     a quarter of the faces, or the target if that is more
 *                simplify the curves to edges in proportion to the square root of the faces, while
 *                  their deviation stays
 *                    within half of the mean edge, so that curves and surface have a similar
 *                      resolution
 *                run the loop down to the faces of the stage
 *     the loop is stuck:  continue with coarser curves until they are stuck, too
 *
 * If edits are proved, edits beyond the error bound are rejected as well.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_FeatureCurveStages_h
#define BoneDecimate_Core_Decimate_Stages_FeatureCurveStages_h

#include "Decimate/Schedule/StopCriterion.h"

#include <functional>

namespace bonedecimate
{
/// Runs towards the stops and reports fractions from 0 to 1.
using StagedLoop = std::function<StopReason(const StopTargets& stops, const Monitor& monitor)>;

StopReason RunInStages(
  Editor& editor, const StopTargets& stops, const Monitor& monitor, const StagedLoop& loop);
}

#endif
