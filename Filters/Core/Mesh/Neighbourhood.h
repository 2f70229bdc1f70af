// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Neighbourhood.h
 * @brief What lies around an edge, gathered once and handed to the gate, the placement and the costs.
 *
 *          p1 ---- a0 ---- qn            Start, End   the ends of the edge
 *         /  \    /  \    /  \           a0, a1       apexes of the gone faces (a1 not on a border)
 *       p2 -- Start-->End -- q2          Corners      half-edges of the staying faces that leave Start or End,
 *         \  /    \  /    \  /                        counter-clockwise round the future vertex
 *          pn ---- a1 ---- q1            Ring         what they point at and, on a border, the last one besides:
 *                                                     face i spans Ring[i] and Ring[i + 1]
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
  std::vector<Index> Ring;     ///< The link of the edge, in the same order.
  bool IsOpen = false;         ///< The ring does not close: an end lies on a border.
  /// On an open ring: which of the ends its first and its last vertex share their border edge with.
  std::array<Index, 2> BorderEnds = { None, None };

  bool IsBorderEdge() const { return this->NumberOfGoneFaces == 1; }

  /// Gathers anew without allocating; neither end may be locked, and not both on a border unless the edge is.
  void Gather(const HalfEdgeMesh& mesh, Index edge);

  /// The link condition: no vertex is met twice on the ring, and no end lies on it.
  bool RingIsSimple() const;
};
}

#endif
