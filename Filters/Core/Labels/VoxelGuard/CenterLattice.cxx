// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CenterLattice.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
/// Rounded down.
std::int64_t Quotient(std::int64_t a, std::int64_t b)
{
  return a / b - (a % b < 0 ? 1 : 0);
}
}

CenterLattice::CenterLattice(const VoxelGrid& grid)
{
  if (grid.Layers.size() < 2)
  {
    return;
  }
  for (std::size_t k = 0; k < grid.Layers.size(); ++k)
  {
    const double units = static_cast<double>(UnitsOfVoxel) * grid.StepsOf(static_cast<double>(k));
    this->Layers.push_back(static_cast<std::int64_t>(std::llround(units)));
  }
}

CenterLattice CenterLattice::Mirrored() const
{
  CenterLattice mirrored;
  mirrored.Layers.assign(this->Layers.rbegin(), this->Layers.rend());
  for (std::int64_t& coordinate : mirrored.Layers)
  {
    coordinate = -coordinate;
  }
  return mirrored;
}

//------------------------------------------------------------------------------
std::int64_t CenterLattice::LayerCoordinate(std::int64_t index) const
{
  const auto last = static_cast<std::int64_t>(this->Layers.size()) - 1;
  if (index < 0)
  {
    return this->Layers[0] + index * (this->Layers[1] - this->Layers[0]);
  }
  if (index > last)
  {
    const std::int64_t end = this->Layers.back();
    return end + (index - last) * (end - this->Layers[static_cast<std::size_t>(last) - 1]);
  }
  return this->Layers[static_cast<std::size_t>(index)];
}

//------------------------------------------------------------------------------
std::int64_t CenterLattice::LayerAtOrBelow(std::int64_t coordinate) const
{
  const std::int64_t first = this->Layers.front();
  const std::int64_t end = this->Layers.back();
  if (coordinate < first)
  {
    return Quotient(coordinate - first, this->Layers[1] - first);
  }
  if (coordinate >= end)
  {
    const auto last = static_cast<std::int64_t>(this->Layers.size()) - 1;
    return last +
      Quotient(coordinate - end, end - this->Layers[static_cast<std::size_t>(last) - 1]);
  }
  const auto above = std::upper_bound(this->Layers.begin(), this->Layers.end(), coordinate);
  return above - this->Layers.begin() - 1;
}
}
