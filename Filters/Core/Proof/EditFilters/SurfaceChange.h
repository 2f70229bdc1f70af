// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceChange.h
 * @brief A change of the surface by any kind of edit: the one argument of rules, filters, proofs,
 * journal and log.
 *
 *     the schedule sets    the worker that proposes it, and its estimates
 *     the rules set        the edit, its component and volume, the faces that it removes
 *                          and those that replace them
 *     the filters          accept, reject or defer it, and commit it after it was made
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_SurfaceChange_h
#define BoneDecimate_Core_Proof_EditFilters_SurfaceChange_h

#include "FragmentVolumes.h"
#include "Mesh/EdgeNeighborhood.h"
#include "Mesh/Edit.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/VertexRange.h"

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
    FaceId SplitFrom = {};          // the old face of a face that a split makes; else None

    FaceId Old() const { return this->SplitFrom == FaceId() ? this->Id : this->SplitFrom; }
  };
  struct BoundaryEdge
  {
    HalfEdgeId Id; // of its half-edge, after the edit
    std::array<VertexId, 2> Vertices;
    std::array<Vector3, 2> Ends;
    HalfEdgeId Replaces = None; ///< If BoundaryStays: the old half-edge at the same position.
    /// The ends, but a stationary one, where several curves meet, is replaced by a vertex that lies
    /// on this curve alone.
    std::array<VertexId, 2> CurveVertices = {};
  };

  VertexRange Range;                          ///< What may be read and written.
  int Workers = 1;                            ///< How many edit the mesh at the same time.
  float Rank = 0.0F;                          ///< Cost of a collapse, for the log (EditRecorder.h).
  double AccumulatedError = 0.0;              ///< mm, the schedule's estimate for a collapse.
  const FragmentVolumes* Unsettled = nullptr; ///< Volumes of the worker.

  /// The edit; the first one if an edge is collapsed in several manifold patches.
  Edit Requested;
  VertexId Vertex;           ///< A vertex of the component that changes.
  double VolumeChange = 0.0; ///< mm^3, of that component.
  FaceId SecondRemovedFace;  ///< The other face that a collapse removes; None on a boundary.

  double Reach = 0.0; ///< mm around its faces, read by the filters.

  // Filled only if a filter needs them.
  std::vector<Index> OldFaces;
  std::vector<Face> NewFaces; // ids of old faces or free ids
  std::vector<Index> OldBoundary;
  std::vector<BoundaryEdge> NewBoundary;
  bool BoundaryStays = false;   ///< Boundary edges only change faces.
  std::array<VertexId, 2> Ends; ///< All faces of these vertices change.
  VertexId MovedVertex;         ///< The vertex that is new or moves; None if none is.

  /// Fills the faces for the requested edit.
  /// @param around Neighborhood of the edge; only for a collapse.
  void Fill(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around);
  /// Adds a collapse in another manifold patch that ends at the same original vertex.
  void AddCollapse(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Edit& edit);
  /// Replaces the new faces by the old ones that still exist, as the edit left them.
  void TakeNewFaces(const HalfEdgeMesh& after);

private:
  void FillMove(const HalfEdgeMesh& mesh);
  /// Must agree with HalfEdgeMesh::Flip.
  void FillFlip(const HalfEdgeMesh& mesh);
  void FillSplit(const HalfEdgeMesh& mesh);
  void AddOld(const HalfEdgeMesh& mesh, FaceId face, Index at, Index orAt);
  void SplitFace(const HalfEdgeMesh& mesh, HalfEdgeId edge, VertexId vertex, FaceId made);
  void MoveBoundary(const HalfEdgeMesh& mesh, HalfEdgeId from, HalfEdgeId to);
  void AddBoundary(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Edit& edit);
};
}

#endif
