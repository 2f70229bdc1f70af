// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeLimits.h
 * @brief What the triangles of a result are to be like.
 */
#ifndef BoneDecimate_Core_Mesh_ShapeLimits_h
#define BoneDecimate_Core_Mesh_ShapeLimits_h

#include <limits>

namespace bonedecimate
{
struct ShapeLimits
{
  double LargestCosine = 1.0; ///< That of the least angle; 1: any.
  double EdgeLength = 0.0;    ///< mm, that edges are to have; 0: any.

  bool LimitsAngles() const { return this->LargestCosine < 1.0; }
  bool LimitsEdges() const { return this->EdgeLength > 0.0; }
  bool IsAny() const { return !this->LimitsAngles() && !this->LimitsEdges(); }

  /// mm; longer edges are split. The halves of a longer one differ less from the length than itself.
  double LongestEdge() const
  {
    return this->LimitsEdges() ? 4.0 / 3.0 * this->EdgeLength
                               : std::numeric_limits<double>::infinity();
  }
  /// mm; shorter edges are collapsed. Both limits are those of Botsch and Kobbelt (EdgeSizer.h).
  double ShortestEdge() const { return 0.8 * this->EdgeLength; }
};
}

#endif
