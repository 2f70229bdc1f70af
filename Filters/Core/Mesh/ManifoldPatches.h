// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ManifoldPatches.h
 * @brief Splits a surface into manifold patches and joins them again.
 *
 *     odd edge:   has three or more triangles or inconsistent orientation, or lies between labels
 *     split:      at the ends of odd edges and at points where several fans meet, every fan of
 *                 triangles gets a duplicate of the point
 *     duplicates: all refer to one original vertex, and are stationary
 *
 * Duplicates are never moved or removed on their own. So the patches are joined by replacing each
 * duplicate by its original vertex. Decimate/Edit/PatchRules.h prevents two patches from getting
 * further edges in common.
 *
 * A. Gueziec, G. Taubin, F. Lazarus, B. Horn, Cutting and stitching: converting sets of polygons to
 * manifold surfaces, 2001.
 */
#ifndef BoneDecimate_Core_Mesh_ManifoldPatches_h
#define BoneDecimate_Core_Mesh_ManifoldPatches_h

#include "Cleaning.h"
#include "HalfEdgeMesh.h"

#include <cstdint>

namespace bonedecimate
{
/// Splits the surface and updates its maps. Duplicates are appended; each input point maps to the
/// first one.
/// @param edges The edges of its triangles.
/// @return Whether anything was split. Then the edges have to be matched again.
bool SplitIntoManifoldPatches(CleanSurface& clean, const EdgeMatching& edges, const Rings& rings);
/// The same, where edges between triangles of different labels are odd.
/// @param labels The label of each triangle. Empty: no labels.
bool SplitIntoManifoldPatches(
  CleanSurface& clean, int threads = 1, const std::vector<Index>& labels = {});

/// Number of points without duplicates.
std::int64_t NumberOfOriginalVertices(const CleanSurface& clean);

/// Calls use(surface) with the patches joined.
template <typename Use>
auto WithJoined(const CleanSurface& clean, const Use& use)
{
  const std::vector<Index>& originals = clean.ManifoldPatches.OriginalVertices;
  if (originals.empty())
  {
    return use(clean.Surface);
  }
  Surface joined = clean.Surface;
  for (Triangle& c : joined.Triangles)
  {
    c = { originals[c[0]], originals[c[1]], originals[c[2]] };
  }
  return use(static_cast<const Surface&>(joined));
}
}

#endif
