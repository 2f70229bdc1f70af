// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TunnelFigures.h
 * @brief Tunnels that were closed before the first edit, and those that were left open.
 */
#ifndef BoneDecimate_Core_Figures_TunnelFigures_h
#define BoneDecimate_Core_Figures_TunnelFigures_h

#include "Geometry/Surface.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Why a tunnel that is narrow enough was left open.
enum class TunnelObstacle : int
{
  NoObstacle = 0,
  AmbiguousLoop, ///< It turns partly around the tunnel and partly around bone.
  /// The triangles along its loop are not a band with two edges, or reach an open boundary.
  NoAnnulus,
  Constrained, ///< A point with tolerance 0, a point that is not manifold, or several labels.
  Intersection ///< The plug would intersect the surface.
};
constexpr std::size_t NumberOfTunnelObstacles = 5;

struct ClosedTunnel
{
  double Diameter =
    0.0;               ///< mm, of a circle as long as the shortest closed loop of edges around it.
  double Volume = 0.0; ///< mm^3, of the plug.
  Vector3 Center = Vector3::Zero(); ///< mm, mean of the points of the loop.
};

struct TunnelFigures
{
  bool IsRequested = false;     ///< If false, all other members are meaningless.
  std::int64_t GenusBefore = 0; ///< Number of handles; open boundaries count as closed.
  std::int64_t GenusAfter = 0;
  std::array<std::int64_t, NumberOfTunnelObstacles>
    Left{}; ///< By TunnelObstacle; [NoObstacle] is always 0.
  double Distance =
    0.0; ///< mm, upper bound of the distance between input and closed surface, both directions.
  std::vector<ClosedTunnel> Closed; ///< In the order in which they were closed.

  std::int64_t NumberLeft() const
  {
    std::int64_t sum = 0;
    for (const std::int64_t count : this->Left)
    {
      sum += count;
    }
    return sum;
  }
};
}

#endif
