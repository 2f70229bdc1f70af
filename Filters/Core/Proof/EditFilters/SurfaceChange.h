// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceChange.h
 * @brief A change of the surface, of any kind of edit: the one argument of rules, filters, proofs,
 * journal and log.
 *
 *     the schedule sets    which worker proposes it, and its estimates
 *     the rules set        the edit, what it means for a component, and its faces: those that it
 *                          removes and those that replace them
 *     the filters accept, reject or defer it, and commit it when it has been made
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
    FaceId SplitFrom = {};          // of a face that a split makes: the old one; else None

    FaceId Old() const { return this->SplitFrom == FaceId() ? this->Id : this->SplitFrom; }
  };
  struct BoundaryEdge
  {
    HalfEdgeId Id; // of its half-edge, after the edit
    std::array<VertexId, 2> Vertices;
    std::array<Vector3, 2> Ends;
    HalfEdgeId Replaces = None; ///< If BoundaryStays: the old half-edge at the same position.
    /// Vertices near the ends that lie on this line alone: stationary ones are replaced by one that
    /// is not.
    std::array<VertexId, 2> OnLine = {};
  };

  VertexRange Range;                          ///< What may be read and written.
  int Workers = 1;                            ///< How many edit the mesh at the same time.
  float Rank = 0.0F;                          ///< Cost of a collapse, for the log (EditRecorder.h).
  double AccumulatedError = 0.0;              ///< mm, of a collapse: the estimate of its schedule.
  const FragmentVolumes* Unsettled = nullptr; ///< Volumes of the worker that are not settled.

  /// The edit; the first one if an edge is collapsed in several manifold patches.
  Edit Requested;
  VertexId Vertex;           ///< A vertex of the component that changes.
  double VolumeChange = 0.0; ///< mm^3, of that component.
  FaceId OtherGoneFace;      ///< The other face that a collapse removes; None on a boundary.

  double Reach = 0.0; ///< mm, around its faces: what the filters that accepted it have read.

  // Filled only if a filter needs them.
  std::vector<Index> OldFaces;
  std::vector<Face> NewFaces; // their ids are among the old ones, or those of removed faces
  std::vector<Index> OldBoundary;
  std::vector<BoundaryEdge> NewBoundary;
  bool BoundaryStays = false; ///< The boundary's edges keep their positions and only change faces.
  std::array<VertexId, 2> Ends; ///< Vertices whose faces change all.
  VertexId Moved;               ///< The vertex that is new or moves; None if none is.

  /// Fills the faces by the edit that is requested.
  /// @param around Neighborhood of the edge, for a collapse only.
  void Fill(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around);
  /// Adds the collapse in one more manifold patch; all collapses end at one original vertex.
  void AddCollapse(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Edit& edit);
  /// Takes those of the old faces that are left, as the edit made them.
  void TakeNewFaces(const HalfEdgeMesh& after);

private:
  void FillMove(const HalfEdgeMesh& mesh);
  /// The mesh must turn the edge as HalfEdgeMesh::Flip says.
  void FillFlip(const HalfEdgeMesh& mesh);
  void FillSplit(const HalfEdgeMesh& mesh);
  void AddOld(const HalfEdgeMesh& mesh, FaceId face, Index at, Index orAt);
  void SplitFace(const HalfEdgeMesh& mesh, HalfEdgeId edge, VertexId vertex, FaceId made);
  void MoveBoundary(const HalfEdgeMesh& mesh, HalfEdgeId from, HalfEdgeId to);
  void AddBoundary(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Edit& edit);
};
}

#endif
