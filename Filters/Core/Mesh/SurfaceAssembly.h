// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceAssembly.h
 * @brief From faces and vertices of which only some are alive to triangles and points without gaps, in the same order.
 *
 * The same result whatever the number of threads.
 */
#ifndef BoneDecimate_Core_Mesh_SurfaceAssembly_h
#define BoneDecimate_Core_Mesh_SurfaceAssembly_h

#include "Cleaning.h"
#include "Parallel.h"
#include "Surface.h"

namespace bonedecimate
{
/// corners(face) of the faces for which isAlive(face).
template <typename IsAlive, typename Corners>
std::vector<Triangle> LiveTriangles(
  std::size_t slots, int threads, const IsAlive& isAlive, const Corners& corners)
{
  std::vector<std::size_t> starts = StartsOfBlocks(slots, threads, isAlive);
  std::vector<Triangle> triangles(starts.back());
  ForEachBlock(slots, threads,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t next = starts[block];
      for (std::size_t face = first; face < last; ++face)
      {
        if (isAlive(face))
        {
          triangles[next++] = corners(face);
        }
      }
    });
  return triangles;
}

/// The vertices that are corners, ascending; the corners become places in this list.
std::vector<Index> NumberVertices(
  std::size_t vertexSlots, std::vector<Triangle>& triangles, int threads);

/// Where the vertex goes in the output, mm: what never moved is copied from the input, bit for bit.
/// @param local Where it is now, mm from the local origin.
Vector3 OutputPosition(const Surface& input, const CleanSurface& clean, Index vertex,
  const Vector3& local, bool roundToSingle);

Vector3 RoundedToSingle(const Vector3& position);
}

#endif
