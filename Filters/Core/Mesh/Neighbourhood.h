// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Neighbourhood.h
 * @brief Everything around one edge, gathered once and handed to gate, placement and editor.
 *
 *            x-------apex 0------x
 *           / \      /   \      / \        corners: the half-edges that leave Start or End in faces that stay
 *          /   \    / gone\    /   \       gone: the one or two faces at the edge
 *         x-----Start--->End------x
 *          \   /    \ gone/    \   /
 *           \ /      \   /      \ /
 *            x-------apex 1------x
 */
#ifndef BoneDecimate_Core_Mesh_Neighbourhood_h
#define BoneDecimate_Core_Mesh_Neighbourhood_h

#include "HalfEdgeMesh.h"

#include <array>
#include <vector>

namespace bonedecimate
{
struct Neighbourhood
{
  Index Edge = None; ///< The half-edge asked for, from Start to End.
  Index Start = None;
  Index End = None;
  std::array<Index, 2> GoneFaces = { None, None };
  std::array<Index, 2> Apexes = { None, None };
  Index NumberOfGoneFaces = 0; ///< 1 on a border, else 2.
  std::vector<Index> Corners;  ///< Half-edges of staying faces whose origin is Start or End.
  Index CommonNeighbours = 0;  ///< Vertices joined to both ends by an edge.

  bool IsBorderEdge() const { return this->NumberOfGoneFaces == 1; }
};

/// Gathers neighbourhoods without allocating for each; ends of edges must not be locked.
class NeighbourhoodGatherer
{
public:
  explicit NeighbourhoodGatherer(const HalfEdgeMesh& mesh)
    : Marks(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), 0)
  {
  }

  void Gather(const HalfEdgeMesh& mesh, Index edge, Neighbourhood& around);

private:
  std::vector<std::uint32_t> Marks; // the last gathering in which a vertex was a neighbour of Start
  std::uint32_t Gatherings = 0;
};
}

#endif
