// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceRules.h
 * @brief What no face may become by an edit: the figures of the kernel that judges fans and of SmallEdits.h.
 */
#ifndef BoneDecimate_Core_Kernels_FaceRules_h
#define BoneDecimate_Core_Kernels_FaceRules_h

namespace bonedecimate
{
/// Cosine of the most (78 degrees) by which a face may turn in one step; 90 would let it end on its edge.
constexpr double LeastCosine = 0.2;

/// Quality of a triangle: that times its area over the sum of its squared edges, 1 if it is equilateral.
constexpr double QualityOfEquilateral = 6.928203230275509; // 4 sqrt(3)

/// Below these no face may become worse than before. Collapses want a low one: 0.05 would cost 6 to 9 % of accuracy
/// where few triangles remain. Flips and moves, which are many and come last, lose nothing by the higher one.
constexpr double LeastQualityOfCollapse = 0.005;
constexpr double LeastQualityOfSmallEdit = 0.02;
}

#endif
