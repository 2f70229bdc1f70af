// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartInput.h
 * @brief What a part of a surface (SurfacePart) means for its mesh.
 */
#ifndef BoneDecimate_Core_Input_PartInput_h
#define BoneDecimate_Core_Input_PartInput_h

#include "Decimate.h"
#include "Reference/ReferenceMesh.h"

#include <memory>
#include <optional>
#include <vector>

namespace bonedecimate
{
/// Of each vertex of the mesh, whether other parts have it, too. Empty: none.  @param part May be null.
std::vector<char> SharedVertices(const SurfacePart* part, const CleanSurface& clean);

/// mm from the local origin of the cleaned surface.
std::optional<Zone> LocalZone(const std::optional<Zone>& zone, const CleanSurface& clean);

/// The original of a part that is itself a result. Null if it cannot be used: nothing is left after cleaning.
/// @param input The cleaned part, as its mesh was made from it.
std::unique_ptr<ReferenceMesh> MakeReferenceMesh(
  const SurfacePart& part, const CleanSurface& input, const Options& options);
}

#endif
