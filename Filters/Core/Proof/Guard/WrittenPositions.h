// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WrittenPositions.h
 * @brief Where vertices will be written, bit for bit.
 *
 * Positions of the mesh are relative to its local origin, so their last bits differ from those of
 * the written coordinates. Nearly coplanar faces may pierce each other in one and not in the other.
 */
#ifndef BoneDecimate_Core_Proof_Guard_WrittenPositions_h
#define BoneDecimate_Core_Proof_Guard_WrittenPositions_h

#include "Mesh/Cleaning.h"
#include "Mesh/PointRounding.h"

namespace bonedecimate
{
class WrittenPositions
{
public:
  /// Vertices are written at their positions in the mesh.
  WrittenPositions() = default;
  /// Points that never move are rounded like the others.
  /// @param input The surface from which the clean one was made. Both must outlive this object.
  /// @param error mm, by which vertices may move.
  WrittenPositions(
    const Surface& input, const CleanSurface& clean, double error, const PointRounding& rounding);

  Vector3 Of(VertexId vertex, const Vector3& local) const;
  /// mm, by which the difference of two written coordinates differs at most from the exact
  /// difference of the local ones.
  double Rounding() const { return 2.0 * this->MaxRounding; }

private:
  const Surface* Input = nullptr;
  const CleanSurface* Clean = nullptr;
  PointRounding Rounds = {};
  double MaxRounding = 0.0; // mm, of one coordinate
};
}

#endif
