// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShortLoops.h
 * @brief Short closed loops along edges that do not divide the surface: around tunnels, and around
 * struts.
 *
 *     seeds      points that cover all edges with a signature; every loop sought passes one
 *     for each   shortest paths to all points within half of the length (Dijkstra), with the
 *                signature of each path
 *                an edge between two of these points closes a loop; the shortest of each
 *                signature is kept, at most MaxLoopsOfSeed
 *
 * I. Guskov, Z. Wood, Topological noise removal, 2001, and Z. Wood, H. Hoppe, M. Desbrun, P.
 * Schroeder, Removing excess topology from isosurfaces, 2004: tunnels by their shortest loops.
 */
#ifndef BoneDecimate_Core_Repair_Tunnels_ShortLoops_h
#define BoneDecimate_Core_Repair_Tunnels_ShortLoops_h

#include "Base/Monitor.h"
#include "EdgeGraph.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Limits the memory if a great length lets every seed reach all handles.
constexpr std::size_t MaxLoopsOfSeed = 32;

struct ShortLoop
{
  double Length = 0.0;         ///< mm, along edges.
  std::uint64_t Signature = 0; ///< Not 0.
  std::vector<Index> Points;   ///< In order; the least first, and the lesser of its neighbors next.
};

/**
 * @param maxLength mm, of a loop.
 * @return Simple loops, the shortest first, each once. For every loop sought, there is one of the
 *   same signature that is not longer, unless its seed has too many shorter ones. Does not depend
 *   on the number of threads. Incomplete after an abort.
 */
std::vector<ShortLoop> FindShortLoops(const EdgeGraph& graph, std::size_t points, double maxLength,
  int threads, const Monitor& monitor);
}

#endif
