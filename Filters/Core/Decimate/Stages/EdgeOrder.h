// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeOrder.h
 * @brief Costs and positions of edges by the quadrics of their ends, to select the edges worth
 * evaluating.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_EdgeOrder_h
#define BoneDecimate_Core_Decimate_Stages_EdgeOrder_h

#include "Base/Monitor.h"
#include "Decimate/Kernels/Kernels.h"

#include <vector>

namespace bonedecimate
{
struct RatedEdge
{
  float Cost;       ///< Units of the mesh to the power of 3.5.
  Index Edge;       ///< The half-edge that starts at the vertex it was rated from.
  Vector3 Position; ///< mm from the local origin

  bool operator<(const RatedEdge& other) const
  {
    return this->Cost != other.Cost ? this->Cost < other.Cost : this->Edge < other.Edge;
  }
};

/// Appends the rated edges from an inner vertex to inner vertices. Quadrics must be up to date.
/// @param isOneWay Leaves out edges to vertices with smaller ids.
void RateEdges(
  const HalfEdgeMesh& mesh, VertexId vertex, bool isOneWay, std::vector<RatedEdge>& edges);

/// The cheapest edges of the whole mesh, in an order that depends on the mesh alone. False if the
/// monitor requests a stop.
bool FindCheapest(const HalfEdgeMesh& mesh, std::size_t count, int threads, const Monitor& monitor,
  std::vector<RatedEdge>& edges);
}

#endif
