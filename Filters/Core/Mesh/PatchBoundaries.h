// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchBoundaries.h
 * @brief The curves along which manifold patches meet, as chains of original vertices. Inner
 * vertices of a curve can be removed.
 *
 *     inner vertex:   every duplicate lies on the boundary of its patch, and all have the same
 *                     two neighbors along it
 *     curve:          inner vertices between two ends that are not inner vertices
 *     closed curve:   starts and ends at its smallest vertex
 *
 * The vertices never move. So the removed vertices between two remaining ones are still those that
 * followed each other on the curve.
 */
#ifndef BoneDecimate_Core_Mesh_PatchBoundaries_h
#define BoneDecimate_Core_Mesh_PatchBoundaries_h

#include "HalfEdgeMesh.h"

#include <array>
#include <vector>

namespace bonedecimate
{
/// The original vertices next to v along the boundary of its patch, in ascending order; None if v
/// is not on a boundary.
std::array<Index, 2> BoundaryNeighbors(const HalfEdgeMesh& mesh, VertexId v);

/// Whether v is an inner vertex: it has the same two neighbors in every patch.
bool IsInsidePatchBoundary(const HalfEdgeMesh& mesh, VertexId v);

class PatchBoundaries
{
public:
  /// @param mesh Before the first edit. Constrained vertices end a curve.
  explicit PatchBoundaries(const HalfEdgeMesh& mesh);

  /// Number of positions on curves. A common end of several curves counts several times.
  Index NumberOfPositions() const { return static_cast<Index>(this->OriginalVertices.size()); }
  Index NumberOfEdges() const { return this->Edges; }
  Index NumberOfInitialEdges() const { return this->InitialEdges; }

  Index OriginalVertex(Index index) const { return this->OriginalVertices[index]; }
  Index Before(Index index) const { return this->Neighbors[index][0]; }
  Index After(Index index) const { return this->Neighbors[index][1]; }
  /// Whether the vertex is an inner vertex and not removed.
  bool IsRemovable(Index index) const
  {
    return this->Before(index) != None && this->After(index) != None;
  }

  /// The largest distance, mm, of this vertex and of those removed next to it to the edge that
  /// would replace its two edges. Infinite if that edge would have no length, or if a distance
  /// exceeds `limitOf(vertex)`, mm.
  template <typename LimitOf>
  double Deviation(const HalfEdgeMesh& mesh, Index index, const LimitOf& limitOf) const;

  void Remove(Index index);

private:
  using Ends = std::array<Index, 2>;

  void AddCurve(
    Index first, Index second, std::vector<char>& isOpen, const std::vector<Ends>& beside);
  double Distance(const HalfEdgeMesh& mesh, Index original, const Ends& segment) const;

  std::vector<Index> OriginalVertices; // at each position, curve by curve
  std::vector<Ends> Neighbors;         // positions; None beyond an end and if removed
  Index Edges = 0;
  Index InitialEdges = 0;
};

template <typename LimitOf>
double PatchBoundaries::Deviation(
  const HalfEdgeMesh& mesh, Index index, const LimitOf& limitOf) const
{
  const Ends segment = { this->OriginalVertex(this->Before(index)),
    this->OriginalVertex(this->After(index)) };
  double maxDeviation = segment[0] == segment[1] ? Infinity : 0.0;
  for (Index between = this->Before(index) + 1; between < this->After(index); ++between)
  {
    const double distance = this->Distance(mesh, this->OriginalVertex(between), segment);
    const bool isFar = distance > limitOf(this->OriginalVertex(between));
    maxDeviation = isFar ? Infinity : std::max(maxDeviation, distance);
  }
  return maxDeviation;
}
}

#endif
