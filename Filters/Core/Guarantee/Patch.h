// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Patch.h
 * @brief An edit as the faces and border edges it takes away and those it puts in their place.
 */
#ifndef BoneDecimate_Core_Guarantee_Patch_h
#define BoneDecimate_Core_Guarantee_Patch_h

#include "Mesh/Edit.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/Neighbourhood.h"

#include <array>
#include <vector>

namespace bonedecimate
{
struct Patch
{
  struct Face
  {
    Index Id;
    Triangle Vertices;
    std::array<Vector3, 3> Corners; // mm from the local origin
  };
  struct BorderEdge
  {
    Index Id; // of its half-edge, after the edit
    std::array<Index, 2> Vertices;
    std::array<Vector3, 2> Ends;
    Index Replaces = None; ///< Where BorderStays: the old half-edge in the same place.
    /// Vertices near the ends that lie on this line alone: pinned ones are replaced by one that is not.
    std::array<Index, 2> OnLine = { None, None };
  };

  std::vector<Index> OldFaces;
  std::vector<Face> NewFaces; // their ids are among the old ones
  std::vector<Index> OldBorder;
  std::vector<BorderEdge> NewBorder;
  bool BorderStays =
    false; ///< The border's edges stay in their places and only belong to other faces.
  std::array<Index, 2> Ends = { None, None }; ///< Vertices whose faces change all.
  Index Moved = None;                         ///< The vertex that is new or moves; None if none is.
  Vector3 Position = Vector3::Zero();

  /// @param around Of the edge to collapse.
  void FillCollapse(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Edit& edit);
  /// The same edge in one more sheet: all in a patch end at one site.
  void AddCollapse(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Edit& edit);
  void FillMove(const HalfEdgeMesh& mesh, const Edit& edit);
  /// The mesh must turn the edge as HalfEdgeMesh::Flip says.
  void FillFlip(const HalfEdgeMesh& mesh, const Edit& edit);

private:
  void Clear();
  void AddOld(const HalfEdgeMesh& mesh, Index face, Index at, Index orAt);
  void AddBorder(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Edit& edit);
};
}

#endif
