// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FreeSlots.h
 * @brief Ids of removed vertices and faces, which edge splits use again.
 *
 * Ids follow the surface (SpatialOrder.h), so a split takes the free id nearest to that of a
 * neighbor.
 */
#ifndef BoneDecimate_Core_Mesh_FreeSlots_h
#define BoneDecimate_Core_Mesh_FreeSlots_h

#include "HalfEdgeMesh.h"

#include <vector>

namespace bonedecimate
{
/// A set of ids that finds the one nearest to a given id, in nearly constant time on average.
class FreeSlots
{
public:
  /// @param isFree For each id.
  explicit FreeSlots(const std::vector<char>& isFree);

  Index Count() const { return this->Remaining; }
  /// The free id nearest to `id` other than `except`, the lower one of two; None if none is left.
  Index FindNearest(Index id, Index except = None);
  void Take(Index id);

private:
  static Index Follow(std::vector<Index>& next, Index at);

  // At id + 1: the next free id + 1 upward or downward, or itself if the id is free. Both ends
  // count as free.
  std::vector<Index> Upward;
  std::vector<Index> Downward;
  Index Remaining = 0;
};

/// The removed vertices of the mesh without duplicates.
FreeSlots FreeVertices(const HalfEdgeMesh& mesh);
/// The removed faces of the mesh.
FreeSlots FreeFaces(const HalfEdgeMesh& mesh);
}

#endif
