// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegionMatch.h
 * @brief Finds the unchanged triangles of a part in its result.
 */
#ifndef BoneDecimate_Core_Partition_Regions_RegionMatch_h
#define BoneDecimate_Core_Partition_Regions_RegionMatch_h

#include "RegionPart.h"

namespace bonedecimate
{
/// Fills OldTriangle and OldPoint. False if a triangle that may not change is not in the result.
bool MatchUnchanged(RegionPart& part);
}

#endif
