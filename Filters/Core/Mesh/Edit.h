// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Edit.h
 * @brief A proposed change of the mesh: an edge collapse, an edge flip, a vertex move, or an edge
 * split.
 */
#ifndef BoneDecimate_Core_Mesh_Edit_h
#define BoneDecimate_Core_Mesh_Edit_h

#include "Handles.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// The maximum number of faces at the vertex that a collapse merges or a move moves. It bounds the
/// cost of an edit. Vertices with more faces wait until collapses around them have removed some.
constexpr Index MaxFacesOfEdit = 128;

enum class EditKind : std::uint8_t
{
  Collapse, ///< The ends of an edge become one vertex.
  Flip,     ///< An edge is replaced by the other diagonal of its two faces.
  Move,     ///< A vertex gets another position.
  Split     ///< An edge gets a vertex inside, and each of its faces becomes two.
};

struct Edit
{
  HalfEdgeId Edge; ///< The half-edge to collapse, flip or split.
  VertexId Keep;   ///< The end whose id is kept, or the vertex that is moved or made.
  /// Position of the merged, moved or new vertex, mm from the local origin.
  Vector3 Position = Vector3::Zero();
  bool KeepStays = false; ///< Whether Keep stays at its position, bit for bit.
  EditKind Kind = EditKind::Collapse;
  std::array<FaceId, 2> Made = {}; ///< The faces that a split makes; the second None on a boundary.
};

inline Edit FlipOf(HalfEdgeId edge)
{
  Edit edit;
  edit.Edge = edge;
  edit.Kind = EditKind::Flip;
  return edit;
}

/// @param position mm from the local origin
inline Edit MoveTo(VertexId vertex, const Vector3& position)
{
  Edit edit;
  edit.Keep = vertex;
  edit.Position = position;
  edit.Kind = EditKind::Move;
  return edit;
}

/// Puts a vertex on the edge.  @param position mm from the local origin
inline Edit SplitAt(HalfEdgeId edge, const Vector3& position)
{
  Edit edit;
  edit.Edge = edge;
  edit.Position = position;
  edit.Kind = EditKind::Split;
  return edit;
}

/// An edge, given by its ends, that is flipped together with an edit.
struct EdgeFlip
{
  VertexId From;
  VertexId To;
};

/// A vertex that moves together with an edit.
struct VertexMove
{
  VertexId Vertex;
  Vector3 Position; ///< mm from the local origin
};

/// Edits that are made after a collapse, as parts of it: first the moves, then the flips.
struct NearbyEdits
{
  std::vector<VertexMove> Moves;
  std::vector<EdgeFlip> Flips;
};
}

#endif
