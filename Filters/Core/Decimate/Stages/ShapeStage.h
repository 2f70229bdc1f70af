// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeStage.h
 * @brief What a run with a least angle does after its collapses: ShapeImprover.h, and where a bound
 * limits edits, more collapses.
 *
 * Proof/EditFilters/ShapeFilter.h keeps the angle in all other stages.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_ShapeStage_h
#define BoneDecimate_Core_Decimate_Stages_ShapeStage_h

#include "StageList.h"

namespace bonedecimate
{
/// Nothing without a least angle. False if the monitor requests a stop.
bool ImproveShape(const StageInput& input, const Monitor& monitor);
}

#endif
