// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GrowingSurface.h
 * @brief The result of a run in slabs so far: what is finished, and what later junctions may change.
 *
 *     Append     the result of a slab; its points in the lower plane are those of the slab before, by their coordinates
 *     Take       moves what reaches into a zone out of it, as a surface of its own
 *     PutBack    the changed strip; its points that stayed are found by their coordinates
 *     Finish     what is below a position is no longer searched
 */
#ifndef BoneDecimate_Core_Pieces_GrowingSurface_h
#define BoneDecimate_Core_Pieces_GrowingSurface_h

#include "SurfacePiece.h"

#include <array>
#include <map>
#include <set>

namespace bonedecimate
{
class GrowingSurface
{
public:
  using Coordinates = std::array<double, 3>;

  /// @param isInLower,isInUpper Of each point of the piece, whether it is in one of its planes.
  void Append(const SurfacePiece& piece, const std::vector<char>& isInLower,
    const std::vector<char>& isInUpper);

  struct Strip
  {
    SurfacePiece Piece;
    std::vector<Index> Points; ///< Of each point, that of the whole.
  };
  Strip Take(const Zone& zone);
  void PutBack(const Strip& taken, const SurfacePiece& changed);
  void Finish(const Zone& above);

  /// Points in the plane below the last piece: of it, and of the piece before.
  const std::set<Index>& Junction() const { return this->InJunction; }

  /// All of it; nothing is left here.
  SurfacePiece Release();

private:
  static Coordinates KeyOf(const Vector3& p) { return { p[0], p[1], p[2] }; }
  void Add(const SurfacePiece& piece, const std::vector<Index>& points);

  std::vector<Vector3> Points;
  SurfacePiece Finished, Open;          // triangles alone
  std::map<Coordinates, Index> InPlane; // the last upper plane
  std::set<Index> InJunction;
};
}

#endif
