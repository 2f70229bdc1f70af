// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointRounding.h
 * @brief How positions are rounded when they are written.
 *
 *     grid      to the nearest whole multiple of a step, for files that hold whole numbers
 *     single    to the nearest number of single precision
 *
 * What is proved is proved of rounded positions: edits move vertices to where they will be written,
 * and the error bound keeps what rounding takes of vertices that never move.
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
  double GridStep =
    0.0; ///< mm; 0: no grid. A power of two is exact in any precision that has the bits.

  bool HasGrid() const { return this->GridStep > 0.0; }
  bool Rounds() const { return this->ToSingle || this->HasGrid(); }

  /// @param position mm, in the frame of the output.
  Vector3 Of(const Vector3& position) const;

  /// The same of a position relative to an origin.
  Vector3 OfLocal(const Vector3& local, const Vector3& origin) const;
};
}

#endif
