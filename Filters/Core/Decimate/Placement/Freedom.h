// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Freedom.h
 * @brief The boundary rule of the quadric placement: where the merged vertex of an edge may go.
 *
 *     both ends free                            anywhere                      Space
 *     a boundary edge                           on the edge                   Edge
 *     one end constrained more than the other   onto that end                 First, Second
 *     an inside edge between boundary vertices, or two ends that stay: the edge is not collapsed
 *       Nowhere
 *
 * An open boundary therefore moves only along itself.
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

/// An open boundary moves only along itself; stationary vertices do not move.
/// @param first Not one that is constrained: edges are evaluated from vertices that may move.
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
