// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeGraph.h
 * @brief The edges of a manifold surface as a graph, with a word for each from which the homology
 * of a loop follows.
 *
 *     tree:       a spanning tree of the points of each component
 *     cotree:     a spanning tree of the faces, across edges that are not in the tree; each
 *                 boundary counts as one more face
 *     leftover:   the edges in neither, 2 for each handle; with the cotree each closes
 *                 a loop of faces, its dual loop
 *     signature:  of each edge the exclusive or of the random words of all leftover
 *                 edges whose dual loop crosses it
 *
 * The exclusive or of the signatures along a closed loop is 0 if the loop divides the surface, and
 * otherwise not, up to 2^-64: the dual loops are a basis of the homology with coefficients 0 and 1.
 *
 * D. Eppstein, Dynamic generators of topologically embedded graphs, 2003: tree and cotree.
 * J. Erickson, K. Whittlesey, Greedy optimal homotopy and homology generators, 2005: short loops.
 */
#ifndef BoneDecimate_Core_Repair_Tunnels_EdgeGraph_h
#define BoneDecimate_Core_Repair_Tunnels_EdgeGraph_h

#include "Geometry/Surface.h"
#include "Mesh/EdgeMatching.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
struct GraphEdge
{
  std::array<Index, 2> Ends;   ///< Points.
  std::array<Index, 2> Sides;  ///< Faces; those from the number of triangles on are boundaries.
  double Length = 0.0;         ///< mm
  std::uint64_t Signature = 0; ///< See above.
};

/// An edge from a point.
struct GraphSpoke
{
  Index To;   ///< Point.
  Index Edge; ///< Index into Edges().
};

class EdgeGraph
{
public:
  /// @param surface Manifold, with or without boundary; points without triangles are allowed. Must
  ///   outlive this object.
  explicit EdgeGraph(const Surface& surface, int threads);

  const std::vector<GraphEdge>& Edges() const { return this->EdgeList; }
  std::int64_t Components() const { return this->NumberOfComponents; }
  /// Sum of the genera of all components; boundaries count as closed.
  std::int64_t Genus() const { return this->NumberOfLeftovers / 2; }

  const GraphSpoke* Begin(Index point) const
  {
    return this->Spokes.data() + this->Start[static_cast<std::size_t>(point)];
  }
  const GraphSpoke* End(Index point) const { return this->Begin(point + 1); }

  /// Half-edge 4 f + k of triangle f: its twin, negative at a boundary.
  Index Twin(Index halfEdge) const
  {
    return this->Matching.Twins()[static_cast<std::size_t>(halfEdge)];
  }
  /// The half-edge at which the ring of a point starts; None if no triangle uses it.
  Index Outgoing(Index point) const
  {
    return this->PointRings.Outgoing[static_cast<std::size_t>(point)];
  }

private:
  struct Cotrees
  {
    std::vector<Index> EdgeToParent; // of each face and boundary; None of a root
    std::vector<Index> Order;        // of faces and boundaries, each after its parent
  };

  void NumberBoundaries();
  void MakeEdges(const Surface& surface);
  void MakeSpokes(std::size_t points);
  std::vector<bool> GrowTrees(std::size_t points);
  Cotrees GrowCotrees(const std::vector<bool>& isInTree) const;
  void SetSignatures(const std::vector<bool>& isInTree, const Cotrees& trees);

  const std::vector<Triangle>& Triangles;
  EdgeMatching Matching;
  Rings PointRings;
  std::vector<Index> BoundaryOf; // of each half-edge without a twin; None otherwise
  Index NumberOfBoundaries = 0;
  std::vector<GraphEdge> EdgeList;
  std::vector<Index> Start; // of each point its first spoke, and finally their number
  std::vector<GraphSpoke> Spokes;
  std::int64_t NumberOfComponents = 0;
  std::int64_t NumberOfLeftovers = 0;
};
}

#endif
