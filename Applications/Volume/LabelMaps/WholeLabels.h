// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WholeLabels.h
 * @brief Values of voxels as labels: rounded where a header's slope left a fraction, rejected where
 * they are none.
 */
#ifndef BoneDecimate_Applications_WholeLabels_h
#define BoneDecimate_Applications_WholeLabels_h

#include "vtkImageData.h"

#include <string>

namespace bonedecimate::volume
{
struct WholeLabels
{
  std::string Problem; ///< Why the values are no labels; empty if they are.
  std::string Note;    ///< Which value was rounded; empty if none was.
};

/**
 * Rounds values in place that are less than a hundredth from whole numbers.
 * @param slab A label map, or layers of it: the extent says which.
 */
WholeLabels MakeWholeLabels(vtkImageData* slab);
}

#endif
