// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointRounding.h
 * @brief How positions are rounded when they are written.
 *
 *     grid      to the nearest multiple of a step, for files that store whole numbers
 *     single    to the nearest number of single precision
 *
 * Proofs refer to rounded positions: edits move vertices to rounded positions, and the error bound
 * keeps a reserve for the rounding of vertices that never move.
 */
#ifndef BoneDecimate_Core_Mesh_PointRounding_h
#define BoneDecimate_Core_Mesh_PointRounding_h

#include "Geometry/Surface.h"

namespace bonedecimate
{
Vector3 RoundedToSingle(const Vector3& position);

struct PointRounding
{
  bool ToSingle = false;
  /// mm; 0: no grid. A power of two keeps multiples exact in any precision that has enough bits.
  double GridStep = 0.0;

  bool HasGrid() const { return this->GridStep > 0.0; }
  bool Rounds() const { return this->ToSingle || this->HasGrid(); }

  /// The rounded position. @param position mm, in the frame of the output.
  Vector3 Of(const Vector3& position) const;

  /// The same for a position relative to an origin.
  Vector3 OfLocal(const Vector3& local, const Vector3& origin) const;
};
}

#endif
