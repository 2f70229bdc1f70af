// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelVictims.h
 * @brief Random label maps for the attack: noise, thin plates, parts that touch, shells at one
 * voxel's distance, slits.
 */
#ifndef BoneDecimate_Testing_LabelVictims_h
#define BoneDecimate_Testing_LabelVictims_h

#include "LabelMaps.h"
#include "Random.h"

namespace bonedecimate::testsupport
{
/// Two to ten voxels along each axis, two to five labels. Spacing, axes and origin are arbitrary;
/// the origin may be 10^5 voxels away.
LabelMap AnyLabelMap(Random& random);
}

#endif
