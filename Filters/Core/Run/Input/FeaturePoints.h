// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FeaturePoints.h
 * @brief Points on the feature curves of a surface: open boundaries and sharp edges.
 */
#ifndef BoneDecimate_Core_Run_Input_FeaturePoints_h
#define BoneDecimate_Core_Run_Input_FeaturePoints_h

#include "Geometry/Surface.h"

#include <vector>

namespace bonedecimate
{
/// For each point whether it lies on an edge of exactly one triangle. Equal points are merged, as
/// in the decimation.
std::vector<bool> PointsOnBoundaries(const Surface& surface, int threads = 1);

/// For each point whether it lies on an edge whose two normals enclose an angle of smaller cosine,
/// or on an edge that is not manifold or not consistently oriented.
std::vector<bool> PointsOnFolds(const Surface& surface, double cosine, int threads = 1);
}

#endif
