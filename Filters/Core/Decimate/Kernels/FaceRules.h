// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceRules.h
 * @brief Limits for faces after an edit, used by the kernel that checks fans and by
 * Decimate/Edit/FlipAndMoveRules.h.
 */
#ifndef BoneDecimate_Core_Decimate_Kernels_FaceRules_h
#define BoneDecimate_Core_Decimate_Kernels_FaceRules_h

namespace bonedecimate
{
/// Cosine of the largest rotation of a face in one step, 78 degrees; 90 would allow a face
/// perpendicular to the surface.
constexpr double MinCosine = 0.2;

/// Quality of a triangle: this factor times its area over the sum of its squared edges, 1 if it is
/// equilateral.
constexpr double QualityOfEquilateral = 6.928203230275509; // 4 sqrt(3)

/// Below these limits, no face may become worse. The limit for collapses is low: 0.05 would cost 6
/// to 9 % of accuracy where few triangles remain. Flips and moves are many and come last, so they
/// lose nothing by a higher limit.
constexpr double MinQualityOfCollapse = 0.005;
constexpr double MinQualityOfSmallEdit = 0.02;
/// Ratio of the new to the old quality above which a face has not become worse by a collapse.
/// Parallel needles, as on the wall of a fine cylinder, lose the square of a small angle when one
/// of their ends moves across.
constexpr double MinRatioOfQuality = 0.99999;
}

#endif
