// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoneSize.h
 * @brief Whether a surface can be a bone in millimeters.
 */
#ifndef BoneDecimate_Core_Mesh_BoneSize_h
#define BoneDecimate_Core_Mesh_BoneSize_h

namespace bonedecimate
{
/// From 2 mm (an ossicle) to 3 m (a whole skeleton). @param diagonal Diagonal of the bounding box,
/// mm.
inline bool IsBoneSize(double diagonal)
{
  return diagonal >= 2.0 && diagonal <= 3000.0;
}
}

#endif
