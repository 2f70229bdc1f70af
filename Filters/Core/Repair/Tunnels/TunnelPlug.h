// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TunnelPlug.h
 * @brief Closes a tunnel at a loop around it: a band of triangles along the loop is replaced by two
 * caps.
 *
 *     band       the triangles at the points of the loop, on both sides or on one; an annulus
 *     caps       triangles of least area on its two rims, without new points and without
 *                edges that the surface has
 *     plug       the volume between the band and the caps: it must be positive, and the caps
 *                must intersect nothing
 */
#ifndef BoneDecimate_Core_Repair_Tunnels_TunnelPlug_h
#define BoneDecimate_Core_Repair_Tunnels_TunnelPlug_h

#include "EdgeGraph.h"
#include "Figures/TunnelFigures.h"
#include "PluggedSurface.h"

#include <utility>
#include <vector>

namespace bonedecimate
{
struct TunnelPlug
{
  std::vector<Index> Band; ///< Triangles of the graph.
  std::vector<Triangle> Caps;
  double Volume = 0.0; ///< mm^3
};

class PlugMaker
{
public:
  /// @param graph The graph of the remaining triangles.
  /// @param ids Their ids in the surface.
  PlugMaker(const PluggedSurface& surface, const EdgeGraph& graph, const Surface& remaining,
    const std::vector<Index>& ids, const TunnelConstraints& constraints)
    : Plugged(surface)
    , Graph(graph)
    , Remaining(remaining)
    , Ids(ids)
    , Constraints(constraints)
  {
  }

  /// @param loop Points in order, a simple loop.
  TunnelObstacle Make(const std::vector<Index>& loop, TunnelPlug& plug) const;

private:
  enum class Side
  {
    Both,
    Left,
    Right
  };
  TunnelObstacle MakeOn(Side side, const std::vector<Index>& loop, TunnelPlug& plug) const;
  bool AddRing(Side side, Index before, Index point, Index after, std::vector<Index>& band) const;
  std::vector<Index> BandAlong(const std::vector<Index>& loop, Side side) const;
  bool IsFree(const std::vector<Index>& band) const;
  std::vector<std::vector<Index>> RimsOf(const std::vector<Index>& band) const;
  bool AddCap(const std::vector<Index>& rim, TunnelPlug& plug) const;
  bool HasOtherEdge(Index a, Index b, const std::vector<Index>& band) const;
  double VolumeOf(const TunnelPlug& plug) const;
  bool Intersects(const TunnelPlug& plug) const;

  const PluggedSurface& Plugged;
  const EdgeGraph& Graph;
  const Surface& Remaining;
  const std::vector<Index>& Ids;
  const TunnelConstraints& Constraints;
};
}

#endif
