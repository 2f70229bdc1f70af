// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceAssembly.h
 * @brief Compacts live faces and vertices into triangles and points, in the same order.
 *
 * The result does not depend on the number of threads.
 */
#ifndef BoneDecimate_Core_Mesh_SurfaceAssembly_h
#define BoneDecimate_Core_Mesh_SurfaceAssembly_h

#include "Base/Parallel.h"
#include "Cleaning.h"
#include "Geometry/Surface.h"
#include "PointRounding.h"

namespace bonedecimate
{
/// corners(face) of all faces for which isAlive(face) holds.
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

/// The vertices that are corners, in ascending order. Replaces the corners by indices into this
/// list.
std::vector<Index> NumberVertices(
  std::size_t vertexSlots, std::vector<Triangle>& triangles, int threads);

/// Rounded position of the vertex in the output, mm. Without rounding, a vertex that never moved
/// keeps the bits of the input.
/// @param local Current position, mm from the local origin.
Vector3 OutputPosition(const Surface& input, const CleanSurface& clean, VertexId vertex,
  const Vector3& local, const PointRounding& rounding);
}

#endif
