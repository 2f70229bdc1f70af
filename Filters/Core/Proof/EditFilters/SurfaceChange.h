// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceChange.h
 * @brief An edit as the faces and boundary edges that it removes and those that replace them.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_SurfaceChange_h
#define BoneDecimate_Core_Proof_EditFilters_SurfaceChange_h

#include "Mesh/EdgeNeighborhood.h"
#include "Mesh/Edit.h"
#include "Mesh/HalfEdgeMesh.h"

#include <array>
#include <vector>

namespace bonedecimate
{
struct SurfaceChange
{
  struct Face
  {
    FaceId Id;
    Triangle Vertices;
    std::array<Vector3, 3> Corners; // mm from the local origin
    FaceId SplitFrom = {};          // of a face that a split makes: the old one; else None

    FaceId Old() const { return this->SplitFrom == FaceId() ? this->Id : this->SplitFrom; }
  };
  struct BoundaryEdge
  {
    HalfEdgeId Id; // of its half-edge, after the edit
    std::array<VertexId, 2> Vertices;
    std::array<Vector3, 2> Ends;
    HalfEdgeId Replaces = None; ///< If BoundaryStays: the old half-edge at the same position.
    /// Vertices near the ends that lie on this line alone: stationary ones
    /// are replaced by one that is not.
    std::array<VertexId, 2> OnLine = {};
  };

  std::vector<Index> OldFaces;
  std::vector<Face> NewFaces; // their ids are among the old ones, or those of removed faces
  std::vector<Index> OldBoundary;
  std::vector<BoundaryEdge> NewBoundary;
  bool BoundaryStays = false; ///< The boundary's edges keep their positions and only change faces.
  std::array<VertexId, 2> Ends; ///< Vertices whose faces change all.
  VertexId Moved;               ///< The vertex that is new or moves; None if none is.
  Vector3 Position = Vector3::Zero();

  /// @param around Neighborhood of the edge to collapse.
  void FillCollapse(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Edit& edit);
  /// Adds the collapse in one more manifold patch; all collapses end at one original vertex.
  void AddCollapse(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Edit& edit);
  /// Takes those of the old faces that are left, as the edit made them.
  void TakeNewFaces(const HalfEdgeMesh& after);
  void FillMove(const HalfEdgeMesh& mesh, const Edit& edit);
  /// The mesh must turn the edge as HalfEdgeMesh::Flip says.
  void FillFlip(const HalfEdgeMesh& mesh, const Edit& edit);
  void FillSplit(const HalfEdgeMesh& mesh, const Edit& edit);

private:
  void Clear();
  void AddOld(const HalfEdgeMesh& mesh, FaceId face, Index at, Index orAt);
  void SplitFace(const HalfEdgeMesh& mesh, HalfEdgeId edge, VertexId vertex, FaceId made);
  void MoveBoundary(const HalfEdgeMesh& mesh, HalfEdgeId from, HalfEdgeId to);
  void AddBoundary(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Edit& edit);
};
}

#endif
