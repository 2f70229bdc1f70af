// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointGraph.h
 * @brief The points of a surface and their neighbors along edges of triangles.
 */
#ifndef BoneDecimate_Core_Mesh_PointGraph_h
#define BoneDecimate_Core_Mesh_PointGraph_h

#include "Geometry/Surface.h"

#include <utility>
#include <vector>

namespace bonedecimate
{
class PointGraph
{
public:
  /// @param duplicates For each point, a point at the same position, which counts as its neighbor.
  /// Empty: there are none.
  explicit PointGraph(const Surface& surface, const std::vector<Index>& duplicates = {});

  /// Calls visit(neighbor) for each neighbor. Some neighbors are visited twice.
  template <typename Visit>
  void VisitNeighbors(Index point, const Visit& visit) const
  {
    const auto p = static_cast<std::size_t>(point);
    for (std::size_t k = this->Starts[p]; k < this->Starts[p + 1]; ++k)
    {
      visit(this->Neighbors[k]);
    }
  }

private:
  template <typename Add>
  static void AddAll(const Surface& surface, const std::vector<Index>& duplicates, const Add& add);

  std::vector<std::size_t> Starts; // of each point, and the end
  std::vector<Index> Neighbors;
};
}

#endif
