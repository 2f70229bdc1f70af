// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelValues.h
 * @brief Whether the values of voxels are intensities, as those of a CT, or names of parts.
 */
#ifndef BoneDecimate_Applications_VoxelValues_h
#define BoneDecimate_Applications_VoxelValues_h

#include "Volume.h"

#include <vector>

namespace bonedecimate::volume
{
enum class ValueKind
{
  Intensities,
  Mask,  ///< 0 and one other whole number.
  Labels ///< A number for each part: an order or a value between two of them means nothing.
};

struct ValueSurvey
{
  ValueKind Kind = ValueKind::Intensities;
  std::vector<int> Labels; ///< Of a mask or a label map, ascending, without 0.
};

/**
 * Labels are whole numbers from 0 to 65535, at most 1,024 of them, at least two beside 0. Among
 * neighbors that are both not 0
 *
 *     most pairs are of equal numbers, for all labels together and for at least half of them each,
 *
 * which intensities are not: between tissues lie voxels of every value, and each tissue has noise.
 * Where a header says that the volume is a segmentation the neighbors are not looked at.
 */
ValueSurvey SurveyValues(const Volume& volume);
}

#endif
