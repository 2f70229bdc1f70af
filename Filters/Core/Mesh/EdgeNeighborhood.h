// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeNeighborhood.h
 * @brief The neighborhood of an edge, gathered once for validity checks, placement and costs.
 *
 *          p1 ---- a0 ---- qn       Start, End   the ends of the edge
 *         /  \    /  \    /  \      a0, a1       apexes of the removed faces (no a1 on a boundary)
 *       p2 -- Start-->End -- q2     Corners      outgoing half-edges of Start or End in remaining
 *         \  /    \  /    \  /                   faces, counter-clockwise around the merged vertex
 *          pn ---- a1 ---- q1       Ring         their targets and, on a boundary, also the last
 *                                                vertex: face i spans Ring[i] and Ring[i + 1]
 */
#ifndef BoneDecimate_Core_Mesh_EdgeNeighborhood_h
#define BoneDecimate_Core_Mesh_EdgeNeighborhood_h

#include "HalfEdgeMesh.h"

#include <array>
#include <vector>

namespace bonedecimate
{
struct EdgeNeighborhood
{
  HalfEdgeId Edge; ///< The half-edge from Start to End.
  VertexId Start;
  VertexId End;
  std::array<FaceId, 2> RemovedFaces;
  std::array<VertexId, 2> Apexes;
  Index NumberOfRemovedFaces = 0; ///< 1 on a boundary, else 2.
  std::vector<Index> Corners;     ///< Half-edges of remaining faces whose origin is Start or End.
  std::vector<Index> Ring;        ///< The link of the edge; see above.
  bool IsOpen = false;            ///< Whether the ring is open because an end lies on a boundary.
  /// On an open ring, the ends from which boundary edges lead to its first and its last vertex.
  std::array<VertexId, 2> BoundaryEnds;

  bool IsBoundaryEdge() const { return this->NumberOfRemovedFaces == 1; }
  /// The faces of Corners, then the removed ones.
  std::vector<Index> Faces() const;

  /// Replaces the content without allocating memory. No end may be NonManifold, and both may be on
  /// a boundary only if the edge is. If more than MaxFacesOfEdit faces would remain, returns false
  /// and leaves the content undefined.
  bool Gather(const HalfEdgeMesh& mesh, HalfEdgeId edge);

  /// The link condition: no vertex occurs twice on the ring, and no end lies on it.
  bool RingIsSimple() const;

  /// The vertex after Ring[i]. A closed ring continues with its first vertex.
  Index RingAfter(std::size_t i) const { return this->Ring[(i + 1) % this->Ring.size()]; }
  /// The index in Corners of a remaining face at the apex of the k-th removed face.
  std::size_t SlotAtApex(std::size_t k) const;
};

/// Whether the vertex has so many faces that none of its edges can be collapsed: more than
/// MaxFacesOfEdit would remain.
bool IsHub(const HalfEdgeMesh& mesh, VertexId vertex);
inline bool MayMove(const HalfEdgeMesh& mesh, VertexId vertex)
{
  return mesh.MovesFreely(vertex) && !IsHub(mesh, vertex);
}
}

#endif
