// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeLimits.h
 * @brief What the triangles of a result are to be like.
 */
#ifndef BoneDecimate_Core_Mesh_ShapeLimits_h
#define BoneDecimate_Core_Mesh_ShapeLimits_h

#include "Geometry/Surface.h"

#include <memory>

namespace bonedecimate
{
class SizingField;

/// Positions are relative to the local origin of the input.
struct ShapeLimits
{
  double MaxCosine = 1.0;                         ///< That of the least angle; 1: any.
  double EdgeLength = 0.0;                        ///< mm, that edges are to have, at most; 0: any.
  std::shared_ptr<const SizingField> Sizing = {}; ///< Where it is less; null: nowhere.

  bool LimitsAngles() const { return this->MaxCosine < 1.0; }
  bool LimitsEdges() const { return this->EdgeLength > 0.0; }
  bool IsAny() const { return !this->LimitsAngles() && !this->LimitsEdges(); }

  /// mm, that an edge with these ends is to have: the smaller one of those at its ends.
  double RequestedLength(const Vector3& a, const Vector3& b) const;

  /// Edges longer than this multiple of the length are split. The halves of such an edge differ
  /// less from the length than itself.
  static constexpr double SplitRatio = 4.0 / 3.0;
  /// Edges shorter than this fraction of the length are collapsed. Both are those of Botsch and
  /// Kobbelt (EdgeSizer.h).
  static constexpr double CollapseRatio = 0.8;

  /// mm; no longer edge may stay anywhere.
  double SplitLength() const
  {
    return this->LimitsEdges() ? SplitRatio * this->EdgeLength : Infinity;
  }
  /// mm; a shorter one may be split somewhere.
  double MinSplitLength() const;
  /// mm; no edge that is not shorter is collapsed anywhere.
  double CollapseLength() const { return CollapseRatio * this->EdgeLength; }
};
}

#endif
