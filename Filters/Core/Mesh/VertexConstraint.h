// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexConstraint.h
 * @brief What edits may do to a vertex: one value per vertex, and predicates.
 *
 *                          may move             may be removed   collapsed onto   ring
 *     Free                 anywhere             yes              yes              closed
 *     Boundary             along the boundary   yes              yes              open
 *     Stationary           no                   no               yes              closed
 *     StationaryBoundary   no                   no               yes              open
 *     NonManifold          no                   no               no               several fans
 *     Constrained          no                   no               no               closed or open
 *
 * Stationary vertices of a feature curve may be removed with the same edge in all manifold patches
 * (Editor::Try).
 */
#ifndef BoneDecimate_Core_Mesh_VertexConstraint_h
#define BoneDecimate_Core_Mesh_VertexConstraint_h

#include <cstdint>

namespace bonedecimate
{
/// In ascending rank (Outranks).
enum class VertexConstraint : std::uint8_t
{
  Free,               ///< Interior of a manifold patch.
  Boundary,           ///< On an open boundary.
  Stationary,         ///< Interior of its manifold patch, but other patches meet there.
  StationaryBoundary, ///< On the boundary of its manifold patch, where other patches meet it.
  NonManifold,        ///< On a non-manifold edge, or where fans meet in one point, and not split.
  /// No edit may change it: its tolerance is 0, other parts have it, or it is a corner of a face
  /// with such a vertex.
  Constrained
};

/// The vertex never moves, is never removed, and nothing is collapsed onto it. No edit changes a
/// face with three such corners.
constexpr bool IsConstrained(VertexConstraint constraint)
{
  return constraint == VertexConstraint::NonManifold || constraint == VertexConstraint::Constrained;
}

/// The vertex never moves, but vertices may be collapsed onto it.
constexpr bool IsStationary(VertexConstraint constraint)
{
  return constraint == VertexConstraint::Stationary ||
    constraint == VertexConstraint::StationaryBoundary;
}

/// The ring of the vertex is open. False for constrained vertices, whatever their ring.
constexpr bool IsOnBoundary(VertexConstraint constraint)
{
  return constraint == VertexConstraint::Boundary ||
    constraint == VertexConstraint::StationaryBoundary;
}

/// The vertex may move anywhere.
constexpr bool MovesFreely(VertexConstraint constraint)
{
  return constraint == VertexConstraint::Free;
}

/// Whether the merged vertex of an edge takes the position of the first end. If neither end
/// outranks the other, the merged vertex may move as they may.
constexpr bool Outranks(VertexConstraint first, VertexConstraint second)
{
  return first > second;
}

/// Whether the collapse of an edge would move a vertex off the boundary or the feature curve that
/// it lies on, or would pinch the surface: the edge is interior and neither end moves freely.
constexpr bool LeavesBoundary(VertexConstraint first, VertexConstraint second, bool isBoundaryEdge)
{
  return !isBoundaryEdge && !MovesFreely(first) && !MovesFreely(second);
}
}

#endif
