// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Edit.h
 * @brief A proposed change of the mesh: an edge collapse, an edge flip, or a vertex move.
 */
#ifndef BoneDecimate_Core_Mesh_Edit_h
#define BoneDecimate_Core_Mesh_Edit_h

#include "Handles.h"

namespace bonedecimate
{
enum class EditKind : std::uint8_t
{
  Collapse, ///< The ends of an edge become one vertex.
  Flip,     ///< An edge is replaced by the other diagonal of its two faces.
  Move      ///< A vertex gets another position.
};

struct Edit
{
  HalfEdgeId Edge;                    ///< The half-edge to collapse or flip.
  VertexId Keep;                      ///< The end whose id is kept, or the vertex to move.
  Vector3 Position = Vector3::Zero(); ///< Of the merged or moved vertex, mm from the local origin.
  bool KeepStays = false;             ///< Whether Position is that of Keep, bit for bit.
  EditKind Kind = EditKind::Collapse;
};

/// A vertex that moves together with an edit.
struct VertexMove
{
  VertexId Vertex;
  Vector3 Position; ///< mm from the local origin
};
}

#endif
