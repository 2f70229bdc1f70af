// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Edit.h
 * @brief One wish to change the mesh. Today an edge collapse; flips, moves and splits will be further kinds.
 */
#ifndef BoneDecimate_Core_Mesh_Edit_h
#define BoneDecimate_Core_Mesh_Edit_h

#include "Surface.h"

namespace bonedecimate
{
struct Edit
{
  Index Edge = None;                  ///< The half-edge to collapse.
  Index Keep = None;                  ///< The end whose id survives.
  Vector3 Position = Vector3::Zero(); ///< Of the merged vertex, mm from the local origin.
  bool KeepStays = false;             ///< Position is that of Keep, bit for bit.
};
}

#endif
