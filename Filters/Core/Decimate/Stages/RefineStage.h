// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RefineStage.h
 * @brief The second stage of Balanced and Accurate: fits the result of the sweep to samples of the
 * original.
 *
 *     assign to every face the samples of the original near it
 *     flip edges and move vertices
 *     collapse the rest by the change of the sampled error    (Decimate/Cost/SampledErrorCost.h)
 *     flip edges and move vertices again
 *
 * If every edit is proved, the number of the last collapses is not known in advance. Then moves
 * that lower the largest distance leave more of the error bound, and collapses use it
 * (SlackRefinement.h); both alternate as often as the settings of the mode say. If voxels alone
 * limit edits, the last collapses are another sweep.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_RefineStage_h
#define BoneDecimate_Core_Decimate_Stages_RefineStage_h

#include "StageList.h"

namespace bonedecimate
{
StopReason RefineStage(const StageInput& input, const Monitor& monitor);
}

#endif
