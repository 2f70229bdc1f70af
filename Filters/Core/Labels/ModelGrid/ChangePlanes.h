// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChangePlanes.h
 * @brief Between which layers of a label map labels change, along each axis.
 */
#ifndef BoneDecimate_Core_Labels_ModelGrid_ChangePlanes_h
#define BoneDecimate_Core_Labels_ModelGrid_ChangePlanes_h

#include "Labels/LabelMap/LabelImage.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// For each layer along an axis, the number of its voxels whose label differs from that of their
/// neighbor in the layer before; 0 for layer 0.
using PlaneCounts = std::vector<std::int64_t>;

std::array<PlaneCounts, 3> CountPlaneChanges(const LabelImage& image, int threads);
}

#endif
