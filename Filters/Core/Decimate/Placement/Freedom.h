// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Freedom.h
 * @brief Where the merged vertex of an edge may go: the boundary rule of the quadric placement.
 *
 *     both ends free                                      anywhere           Space
 *     a boundary edge                                     on the edge        Edge
 *     one end outranks the other                          onto that end      First, Second
 *     an interior edge between boundary vertices,
 *     or two stationary ends                              not collapsed      Nowhere
 *
 * So an open boundary moves only along itself.
 */
#ifndef BoneDecimate_Core_Decimate_Placement_Freedom_h
#define BoneDecimate_Core_Decimate_Placement_Freedom_h

#include "Mesh/VertexConstraint.h"

#include <cstdint>

namespace bonedecimate
{
enum class Freedom : std::int32_t
{
  Space,  ///< Anywhere that keeps the volume.
  Edge,   ///< On the edge.
  First,  ///< At the first end.
  Second, ///< At the second end.
  Nowhere ///< The edge may not be collapsed.
};

/// @param first A vertex that is not constrained: edges are evaluated from vertices that may move.
inline Freedom FreedomOf(VertexConstraint first, VertexConstraint second, bool isBoundaryEdge)
{
  if (IsConstrained(second) || LeavesBoundary(first, second, isBoundaryEdge))
  {
    return Freedom::Nowhere;
  }
  if (first == second)
  {
    return MovesFreely(first) ? Freedom::Space
      : IsStationary(first)   ? Freedom::Nowhere
                              : Freedom::Edge;
  }
  return Outranks(first, second) ? Freedom::First : Freedom::Second;
}
}

#endif
