// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointGraph.h"

namespace bonedecimate
{
template <typename Add>
void PointGraph::AddAll(
  const Surface& surface, const std::vector<Index>& duplicates, const Add& add)
{
  for (const Triangle& corners : surface.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      add(corners[k], corners[(k + 1) % 3]);
      add(corners[k], corners[(k + 2) % 3]);
    }
  }
  for (std::size_t p = 0; p < duplicates.size(); ++p)
  {
    if (duplicates[p] != static_cast<Index>(p))
    {
      add(static_cast<Index>(p), duplicates[p]);
      add(duplicates[p], static_cast<Index>(p));
    }
  }
}

PointGraph::PointGraph(const Surface& surface, const std::vector<Index>& duplicates)
  : Starts(surface.Points.size() + 1, 0)
{
  AddAll(surface, duplicates,
    [this](Index point, Index) { ++this->Starts[static_cast<std::size_t>(point) + 1]; });
  for (std::size_t p = 1; p < this->Starts.size(); ++p)
  {
    this->Starts[p] += this->Starts[p - 1];
  }
  this->Neighbors.resize(this->Starts.back());
  std::vector<std::size_t> next = this->Starts;
  AddAll(surface, duplicates,
    [&](Index point, Index neighbor)
    { this->Neighbors[next[static_cast<std::size_t>(point)]++] = neighbor; });
}
}
