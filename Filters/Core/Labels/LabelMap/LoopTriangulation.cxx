// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LoopTriangulation.h"

#include <limits>

namespace bonedecimate
{
namespace
{
constexpr double InAFace = 1e9; // costs more than all other diagonals together
constexpr double Tie = 1e-12;   // sums that differ by less are equal but for rounding
constexpr double LongestSquared = 9.0;

class LoopTriangulation
{
public:
  LoopTriangulation(const CellLoop& loop, Diagonals diagonals, CellSurface& surface)
    : Loop(loop)
    , DiagonalRule(diagonals)
    , Surface(surface)
  {
  }

  /// Costs of the polygons first to last, the shorter ones before the longer.
  void Solve()
  {
    for (std::size_t first = 0; first + 1 < this->Loop.Size(); ++first)
    {
      this->Costs[first][first + 1] = 0.0; // an edge of the polygon
    }
    for (std::size_t length = 2; length < this->Loop.Size(); ++length)
    {
      for (std::size_t first = 0; first + length < this->Loop.Size(); ++first)
      {
        this->SolvePart(first, first + length);
      }
    }
  }

  void AddTriangles(std::size_t first, std::size_t last, Index from, Index to)
  {
    if (last - first < 2)
    {
      return;
    }
    const std::size_t middle = this->Apex[first][last];
    this->Surface.Add({ { this->Loop[first], this->Loop[middle], this->Loop[last] }, from, to });
    this->AddTriangles(middle, last, from, to);
    this->AddTriangles(first, middle, from, to);
  }

private:
  template <typename Value>
  using Table = std::array<std::array<Value, FirstInnerPoint>, FirstInnerPoint>;

  void SolvePart(std::size_t first, std::size_t last)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t middle = first + 1; middle < last; ++middle)
    {
      const double cost = this->Costs[first][middle] + this->Costs[middle][last];
      if (cost < least - Tie)
      {
        least = cost;
        this->Apex[first][last] = middle;
      }
    }
    this->Costs[first][last] = least + this->CostOfDiagonal(first, last);
  }

  double CostOfDiagonal(std::size_t first, std::size_t last) const
  {
    if (first == 0 && last == this->Loop.Size() - 1)
    {
      return 0.0; // an edge of the polygon
    }
    const int a = this->Loop[first];
    const int b = this->Loop[last];
    if (OnOneFace[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)])
    {
      return InAFace;
    }
    const double squared = (this->Surface.Position(a) - this->Surface.Position(b)).squaredNorm();
    return this->DiagonalRule == Diagonals::Longest ? LongestSquared - squared : squared;
  }

  const CellLoop& Loop;
  Diagonals DiagonalRule;
  CellSurface& Surface;
  // Written before they are read; initialization would take half of the time.
  Table<double> Costs;
  Table<std::size_t> Apex;
};
}

//------------------------------------------------------------------------------
void TriangulateLoop(
  const CellLoop& loop, Index from, Index to, Diagonals diagonals, CellSurface& surface)
{
  LoopTriangulation triangulation(loop, diagonals, surface);
  triangulation.Solve();
  triangulation.AddTriangles(0, loop.Size() - 1, from, to);
}
}
