// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CornerGrid.h
 * @brief The corners of a large polygon in a grid, to find those in a box.
 */
#ifndef BoneDecimate_Core_Geometry_CornerGrid_h
#define BoneDecimate_Core_Geometry_CornerGrid_h

#include "Surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace bonedecimate
{
/// A grid whose cells hold about the same number of corners along each of two axes.
class CornerGrid
{
public:
  using Position = std::array<double, 2>;

  void Build(const std::vector<Position>& positions)
  {
    this->CellsAlong = 1;
    while (this->CellsAlong * this->CellsAlong * 4 < positions.size())
    {
      ++this->CellsAlong;
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      this->Limits[axis] = QuantilesOf(positions, axis, this->CellsAlong);
    }
    this->Cells.assign(this->CellsAlong * this->CellsAlong, {});
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      const std::size_t row = this->CellOf(1, positions[i][1]);
      this->Cells[row * this->CellsAlong + this->CellOf(0, positions[i][0])].push_back(i);
    }
  }

  /// Index of a corner in the box for which the predicate holds; None if there is none. The
  /// predicate is also called for corners near the box.
  template <typename Predicate>
  Index Find(const Position& low, const Position& high, const Predicate& isFound) const
  {
    const std::size_t lastRow = this->CellOf(1, high[1]);
    const std::size_t lastColumn = this->CellOf(0, high[0]);
    for (std::size_t row = this->CellOf(1, low[1]); row <= lastRow; ++row)
    {
      for (std::size_t column = this->CellOf(0, low[0]); column <= lastColumn; ++column)
      {
        const std::vector<std::size_t>& cell = this->Cells[row * this->CellsAlong + column];
        const auto found = std::find_if(cell.begin(), cell.end(), isFound);
        if (found != cell.end())
        {
          return static_cast<Index>(*found);
        }
      }
    }
    return None;
  }

private:
  /// The largest coordinate of each cell except the last.
  static std::vector<double> QuantilesOf(
    const std::vector<Position>& positions, std::size_t axis, std::size_t cells)
  {
    std::vector<double> sorted;
    sorted.reserve(positions.size());
    std::transform(positions.begin(), positions.end(), std::back_inserter(sorted),
      [axis](const Position& position) { return position[axis]; });
    std::sort(sorted.begin(), sorted.end());
    std::vector<double> limits;
    for (std::size_t cell = 1; cell < cells; ++cell)
    {
      limits.push_back(sorted[cell * sorted.size() / cells]);
    }
    return limits;
  }

  std::size_t CellOf(std::size_t axis, double coordinate) const
  {
    const std::vector<double>& limits = this->Limits[axis];
    return static_cast<std::size_t>(
      std::lower_bound(limits.begin(), limits.end(), coordinate) - limits.begin());
  }

  std::size_t CellsAlong = 1;
  std::array<std::vector<double>, 2> Limits;
  std::vector<std::vector<std::size_t>> Cells;
};
}

#endif
