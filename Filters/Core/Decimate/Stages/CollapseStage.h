// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CollapseStage.h
 * @brief The first stage of every mode: collapses edges by the schedule of the mode, and feature
 * curves before the faces beside them (FeatureCurveStages.h).
 *
 *     VertexQueue    ThesisCollapse, down to the targets
 *     BucketSweep    BucketSweep, down to the targets or, where a refine stage follows, to a few
 *                    faces more
 */
#ifndef BoneDecimate_Core_Decimate_Stages_CollapseStage_h
#define BoneDecimate_Core_Decimate_Stages_CollapseStage_h

#include "StageList.h"

namespace bonedecimate
{
StopReason CollapseStage(const StageInput& input, const Monitor& monitor);

/// Runs a BucketSweep down to that many faces.
StopReason SweepTo(const StageInput& input, Index faces, const Monitor& monitor);
}

#endif
