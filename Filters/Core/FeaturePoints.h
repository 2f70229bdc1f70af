// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FeaturePoints.h
 * @brief The points of a surface that lie on its lines: open borders, or edges where it folds.
 */
#ifndef BoneDecimate_Core_FeaturePoints_h
#define BoneDecimate_Core_FeaturePoints_h

#include "Surface.h"

#include <vector>

namespace bonedecimate
{
/// Of each point, whether it lies on an edge of exactly one triangle. Equal points are one, as for the decimation.
std::vector<bool> PointsOnBorders(const Surface& surface, int threads = 1);

/// Of each point, whether it lies on an edge whose two triangles' normals differ by an angle of a smaller cosine, or on one
/// that is not manifold or not consistently oriented.
std::vector<bool> PointsOnFolds(const Surface& surface, double cosine, int threads = 1);
}

#endif
