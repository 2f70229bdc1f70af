// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchSearch.h
 * @brief Where two surfaces are near each other: for vertices at which patches meet, in their own
 * patch.
 */
#ifndef BoneDecimate_Core_Run_Input_PatchSearch_h
#define BoneDecimate_Core_Run_Input_PatchSearch_h

#include "Labels.h"
#include "Labels/LabelMap/VoxelGrid.h"
#include "Mesh/Cleaning.h"

#include <vector>

namespace bonedecimate
{
/// As a mesh was made from it.
struct SurfaceOfPatches
{
  const CleanSurface& Clean;
  const Labels* OfInput;     ///< Labels of the triangles before cleaning; null: none.
  const LabelMapSource* Map; ///< The same, pairs of labels.
};

/// For each vertex of the first surface the nearest triangle of the second one, with the same
/// labels where there are any.
/// @param farthest mm, how far inside of its patch a vertex may be looked for.
std::vector<Index> NearestInPatch(
  const SurfaceOfPatches& from, const SurfaceOfPatches& to, double farthest, int threads);
}

#endif
