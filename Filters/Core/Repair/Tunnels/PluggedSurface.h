// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PluggedSurface.h
 * @brief A surface while its tunnels are closed. Triangles keep their ids; those of plugs are
 * appended.
 */
#ifndef BoneDecimate_Core_Repair_Tunnels_PluggedSurface_h
#define BoneDecimate_Core_Repair_Tunnels_PluggedSurface_h

#include "Geometry/BoundingTree.h"
#include "Geometry/Surface.h"

#include <vector>

namespace bonedecimate
{
/// What must not be removed.
struct TunnelConstraints
{
  std::vector<char> IsFixed; ///< Whether the triangles at a point stay.
  /// One label for each triangle; a plug has one label. Empty: no labels.
  std::vector<Index> Labels;
};

struct PluggedSurface
{
  PluggedSurface(const Surface& surface, int threads)
    : Whole(surface)
    , IsRemoved(surface.Triangles.size(), 0)
    , InitialTriangles(surface.Triangles.size())
    , Tree(surface, threads)
  {
  }

  const Vector3& Point(Index point) const
  {
    return this->Whole.Points[static_cast<std::size_t>(point)];
  }

  Surface Whole; ///< With the removed triangles.
  std::vector<char> IsRemoved;
  std::vector<Index> Replaced;  ///< For each appended triangle one of those that it replaces.
  std::size_t InitialTriangles; ///< Number of triangles before any plug.
  BoundingTree Tree;            ///< Bounding tree of those triangles.
};
}

#endif
