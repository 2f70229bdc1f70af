// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CutEdges.h
 * @brief Edges where a part was cut out of a larger surface. They have one triangle but are no
 * boundaries.
 */
#ifndef BoneDecimate_Core_Mesh_CutEdges_h
#define BoneDecimate_Core_Mesh_CutEdges_h

#include "Geometry/Surface.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace bonedecimate
{
class CutEdges
{
public:
  CutEdges() = default;
  /// @param edges Pairs of original vertices.
  explicit CutEdges(std::vector<std::array<Index, 2>> edges)
    : Edges(std::move(edges))
  {
    for (std::array<Index, 2>& edge : this->Edges)
    {
      std::sort(edge.begin(), edge.end());
    }
    std::sort(this->Edges.begin(), this->Edges.end());
  }

  bool Contain(Index a, Index b) const
  {
    return std::binary_search(this->Edges.begin(), this->Edges.end(),
      std::array<Index, 2>{ std::min(a, b), std::max(a, b) });
  }

private:
  std::vector<std::array<Index, 2>> Edges; // ascending
};
}

#endif
