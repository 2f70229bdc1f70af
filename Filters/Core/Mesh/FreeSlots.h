// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FreeSlots.h
 * @brief Ids of removed vertices and faces that edge splits use again.
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
/// A set of ids of which the one nearest to another id is taken at a time, in nearly constant time
/// on average.
class FreeSlots
{
public:
  /// @param isFree For each id.
  explicit FreeSlots(const std::vector<char>& isFree);

  Index Count() const { return this->Remaining; }
  /// The one nearest to that id, the lower of two, but not `except`; None if there is none left.
  Index FindNearest(Index id, Index except = None);
  void Take(Index id);

private:
  static Index Follow(std::vector<Index>& next, Index at);

  // At id + 1, of each id: the next free id + 1 upward or downward, itself if it is free; both ends
  // always are.
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
