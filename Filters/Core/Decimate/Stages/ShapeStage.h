// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeStage.h
 * @brief Improves shapes after the collapses of a run with a requested angle or edge length
 * (EdgeSizer.h, ShapeImprover.h), and collapses more where a bound limits edits.
 *
 * Proof/EditFilters/ShapeFilter.h keeps the shapes in all other stages.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_ShapeStage_h
#define BoneDecimate_Core_Decimate_Stages_ShapeStage_h

#include "StageList.h"

namespace bonedecimate
{
/// Does nothing if no shape is requested. False if the monitor requests a stop.
bool ImproveShape(const StageInput& input, const Monitor& monitor);
}

#endif
