// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Edit.h
 * @brief One wish to change the mesh: an edge collapsed, an edge flipped, or a vertex moved.
 */
#ifndef BoneDecimate_Core_Mesh_Edit_h
#define BoneDecimate_Core_Mesh_Edit_h

#include "Surface.h"

namespace bonedecimate
{
enum class EditKind : std::uint8_t
{
  Collapse, ///< The ends of an edge become one vertex.
  Flip,     ///< An edge becomes the other diagonal of its two faces.
  Move      ///< A vertex goes elsewhere.
};

struct Edit
{
  Index Edge = None;                  ///< The half-edge to collapse or flip.
  Index Keep = None;                  ///< The end whose id survives, or the vertex to move.
  Vector3 Position = Vector3::Zero(); ///< Of the merged or moved vertex, mm from the local origin.
  bool KeepStays = false;             ///< Position is that of Keep, bit for bit.
  EditKind Kind = EditKind::Collapse;
};
}

#endif
