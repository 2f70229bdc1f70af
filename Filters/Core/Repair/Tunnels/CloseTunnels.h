// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloseTunnels.h
 * @brief Closes the narrow tunnels of a surface. Struts of bone are never cut.
 *
 *     in rounds, until none closes a tunnel:
 *       graph      signatures of the remaining surface                     (EdgeGraph.h)
 *       loops      short ones that do not divide it, the shortest first    (ShortLoops.h)
 *       direction  a tunnel if normals along the loop point to its middle  (Surrounds)
 *       plug       replaces a band along the loop by two caps              (TunnelPlug.h)
 *     a loop whose band was changed in the same round, or that divides the surface by now,
 *     waits for the next one
 */
#ifndef BoneDecimate_Core_Repair_Tunnels_CloseTunnels_h
#define BoneDecimate_Core_Repair_Tunnels_CloseTunnels_h

#include "Base/Monitor.h"
#include "Figures/TunnelFigures.h"
#include "PluggedSurface.h"

#include <vector>

namespace bonedecimate
{
/// The changes of the surface; its points stay as they are.
struct SurfaceWithoutTunnels
{
  std::vector<char> IsRemoved; ///< One flag for each triangle.
  std::vector<Triangle> Added; ///< Triangles of the plugs.
  std::vector<Index> Replaced; ///< For each added triangle one that it replaces.
  TunnelFigures Figures;       ///< All but Conflict.
};

/**
 * @param surface Manifold, with or without boundary (Mesh/ManifoldPatches.h); mm.
 * @param diameter mm; tunnels with a girth of at most pi times this are closed.
 * @param monitor After an abort nothing is closed.
 */
SurfaceWithoutTunnels CloseTunnels(const Surface& surface, const TunnelConstraints& constraints,
  double diameter, int threads, const Monitor& monitor);
}

#endif
