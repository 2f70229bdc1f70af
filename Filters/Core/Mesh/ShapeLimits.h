// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeLimits.h
 * @brief Requested shapes of the triangles of a result.
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
  double MaxCosine = 1.0;                         ///< Cosine of the smallest angle; 1: any.
  double EdgeLength = 0.0;                        ///< Requested at most, mm; 0: any.
  std::shared_ptr<const SizingField> Sizing = {}; ///< Smaller local lengths; null: there are none.

  bool LimitsAngles() const { return this->MaxCosine < 1.0; }
  bool LimitsEdges() const { return this->EdgeLength > 0.0; }
  bool IsLimited() const { return this->LimitsAngles() || this->LimitsEdges(); }

  /// The requested length, mm, of an edge with these ends: the smaller one of those at its ends.
  double RequestedLength(const Vector3& a, const Vector3& b) const;

  /// Edges longer than this multiple of the requested length are split. The halves of such an edge
  /// are nearer to the length than the edge.
  static constexpr double SplitRatio = 4.0 / 3.0;
  /// Edges shorter than this multiple of the requested length are collapsed. Both are the factors
  /// of Botsch and Kobbelt (EdgeSizer.h).
  static constexpr double CollapseRatio = 0.8;

  /// mm; longer edges are split everywhere.
  double SplitLength() const
  {
    return this->LimitsEdges() ? SplitRatio * this->EdgeLength : Infinity;
  }
  /// mm; longer edges are split somewhere.
  double MinSplitLength() const;
  /// mm; only shorter edges are collapsed, wherever they are.
  double CollapseLength() const { return CollapseRatio * this->EdgeLength; }
};
}

#endif
