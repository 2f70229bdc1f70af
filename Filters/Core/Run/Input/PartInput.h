// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartInput.h
 * @brief What a part of a surface (SurfacePart) means for its mesh.
 */
#ifndef BoneDecimate_Core_Run_Input_PartInput_h
#define BoneDecimate_Core_Run_Input_PartInput_h

#include "Geometry/NearSurface.h"
#include "Mesh/CutEdges.h"
#include "Options/Options.h"
#include "Proof/Reference/ReferenceMesh.h"
#include "RunInputs.h"

#include <memory>
#include <optional>
#include <vector>

namespace bonedecimate
{
/// What other parts have near this one.
NeighborSurfaces NeighborsOf(const SurfacePart& part, const CleanSurface& clean, int threads);

/// Whether other parts have a vertex of the mesh, too, or it is a corner of a triangle too near to
/// them. Empty: none.
std::vector<char> SharedVertices(
  const SurfacePart& part, const CleanSurface& clean, const NeighborSurfaces& neighbors);

/// @param edges Pairs of points of the surface that was cleaned.
CutEdges CutEdgesOf(const std::vector<std::array<Index, 2>>& edges, const CleanSurface& clean);

/// mm from the local origin of the cleaned surface.
std::optional<Zone> LocalZone(const std::optional<Zone>& zone, const CleanSurface& clean);

/// The original of a part that is itself a result. Null if it cannot be used:
/// nothing is left after cleaning.
/// @param inputs With the part.  @param input The cleaned part, as its mesh was made from it.
std::unique_ptr<ReferenceMesh> MakeReferenceMesh(
  const RunInputs& inputs, const CleanSurface& input, const Options& options);
}

#endif
