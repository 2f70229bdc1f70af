// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SizingField.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace bonedecimate
{
SizingField::SizingField(const Surface& surface, std::vector<double> lengths, int threads)
  : Tree(surface, threads)
  , Triangles(surface.Triangles)
  , Lengths(std::move(lengths))
  , ShortestLength(*std::min_element(this->Lengths.begin(), this->Lengths.end()))
{
}

//------------------------------------------------------------------------------
SizingField::LocalLength SizingField::At(const Vector3& position, Index hint) const
{
  const BoundingTree::Nearest nearest = this->Tree.FindNearest(position, hint);
  const Triangle& corners = this->Triangles[static_cast<std::size_t>(nearest.Triangle)];
  double length = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    length += nearest.Point.Weights[k] * this->Lengths[static_cast<std::size_t>(corners[k])];
  }
  return { length, nearest.Triangle };
}

//------------------------------------------------------------------------------
/// Starts at the shortest length, like Dijkstra's algorithm.
void GradeLengths(
  const Surface& surface, const PointGraph& graph, double slope, std::vector<double>& lengths)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t p = 0; p < lengths.size(); ++p)
  {
    queue.emplace(lengths[p], static_cast<Index>(p));
  }
  while (!queue.empty())
  {
    const auto [length, point] = queue.top();
    queue.pop();
    if (length > lengths[static_cast<std::size_t>(point)])
    {
      continue;
    }
    const Vector3& here = surface.Points[static_cast<std::size_t>(point)];
    graph.VisitNeighbors(point,
      [&, base = length](Index neighbor)
      {
        const auto n = static_cast<std::size_t>(neighbor);
        const double there = base + slope * (surface.Points[n] - here).norm();
        if (there < lengths[n])
        {
          lengths[n] = there;
          queue.emplace(there, neighbor);
        }
      });
  }
}
}
