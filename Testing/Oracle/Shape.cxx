// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace
{
using Corners = std::array<std::int32_t, 3>;

class Sets
{
public:
  explicit Sets(std::size_t count)
  {
    this->Parent.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Parent.push_back(i);
    }
  }

  std::size_t Find(std::size_t i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }

  void Join(std::size_t a, std::size_t b) { this->Parent[this->Find(a)] = this->Find(b); }

private:
  std::vector<std::size_t> Parent;
};

/// An edge of a triangle, its points in ascending order.
struct Side
{
  std::int32_t Low;
  std::int32_t High;
  std::size_t Triangle;

  bool IsSameEdge(const Side& other) const { return Low == other.Low && High == other.High; }
};

std::vector<Side> SortedSides(const std::vector<Corners>& triangles)
{
  std::vector<Side> sides;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto [low, high] = std::minmax({ triangles[t][k], triangles[t][(k + 1) % 3] });
      sides.push_back({ low, high, t });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    {
      return a.Low != b.Low ? a.Low < b.Low
                            : (a.High != b.High ? a.High < b.High : a.Triangle < b.Triangle);
    });
  return sides;
}

std::size_t CornerOf(const Corners& corners, std::int32_t point)
{
  return static_cast<std::size_t>(
    std::find(corners.begin(), corners.end(), point) - corners.begin());
}

/// Counts edges by their number of triangles; joins the corners of triangles that meet in an edge.
void WalkEdges(
  const std::vector<Corners>& triangles, Shape& shape, Sets& fans, std::vector<char>& isNonManifold)
{
  const std::vector<Side> sides = SortedSides(triangles);
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end)
  {
    for (end = first + 1; end < sides.size() && sides[end].IsSameEdge(sides[first]); ++end)
    {
      for (const std::int32_t point : { sides[first].Low, sides[first].High })
      {
        const std::size_t a = sides[first].Triangle;
        const std::size_t b = sides[end].Triangle;
        fans.Join(3 * a + CornerOf(triangles[a], point), 3 * b + CornerOf(triangles[b], point));
      }
    }
    --shape.EulerNumber;
    shape.BoundaryEdges += end - first == 1 ? 1 : 0;
    if (end - first > 2)
    {
      ++shape.NonManifoldEdges;
      isNonManifold[static_cast<std::size_t>(sides[first].Low)] = 1;
      isNonManifold[static_cast<std::size_t>(sides[first].High)] = 1;
    }
  }
}

/// Points, components, and the points with more than one fan.
void WalkPoints(
  const std::vector<Corners>& triangles, Shape& shape, Sets& fans, std::vector<char>& isNonManifold)
{
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> fanOf(isNonManifold.size(), none);
  Sets components(isNonManifold.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto point = static_cast<std::size_t>(triangles[t][k]);
      const std::size_t fan = fans.Find(3 * t + k);
      components.Join(static_cast<std::size_t>(triangles[t][0]), point);
      isNonManifold[point] |= static_cast<char>(fanOf[point] != none && fanOf[point] != fan);
      fanOf[point] = fan;
    }
  }
  for (std::size_t point = 0; point < fanOf.size(); ++point)
  {
    const bool isUsed = fanOf[point] != none;
    shape.EulerNumber += isUsed ? 1 : 0;
    shape.Components += isUsed && components.Find(point) == point ? 1 : 0;
  }
  shape.NonManifoldVertices = std::count(isNonManifold.begin(), isNonManifold.end(), 1);
}

struct TriangleFigures
{
  double Area = 0.0;
  double Quality = 0.0;       ///< 4 sqrt(3) area / (sum of squared edges)
  double SmallestAngle = 0.0; ///< degrees, opposite the shortest edge
};

TriangleFigures FiguresOf(const Triangles& triangles, const Corners& corners)
{
  std::array<std::array<double, 3>, 3> edge{};
  std::array<double, 3> squares{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto& from = triangles.Points[static_cast<std::size_t>(corners[k])];
    const auto& to = triangles.Points[static_cast<std::size_t>(corners[(k + 1) % 3])];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      edge[k][axis] = to[axis] - from[axis];
      squares[k] += edge[k][axis] * edge[k][axis];
    }
  }
  double crossSquared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t i = (axis + 1) % 3;
    const std::size_t j = (axis + 2) % 3;
    const double cross = edge[0][i] * edge[1][j] - edge[0][j] * edge[1][i];
    crossSquared += cross * cross;
  }
  std::sort(squares.begin(), squares.end());
  const double sum = squares[0] + squares[1] + squares[2];
  TriangleFigures figures;
  figures.Area = 0.5 * std::sqrt(crossSquared);
  figures.Quality = sum > 0.0 ? 4.0 * std::sqrt(3.0) * figures.Area / sum : 0.0;
  // times twice the product of the longer edges
  const double cosine = squares[1] + squares[2] - squares[0];
  figures.SmallestAngle = std::atan2(4.0 * figures.Area, cosine) * 180.0 / std::acos(-1.0);
  return figures;
}

void AddFigures(const TriangleFigures& figures, Shape& shape)
{
  shape.Quality += figures.Quality;
  shape.BadFraction += figures.Quality < 0.2 ? 1.0 : 0.0;
  shape.Degenerate += figures.Area < 1e-8 ? 1 : 0;
  for (std::size_t i = 0; i < shape.SmallAngles.size(); ++i)
  {
    shape.SmallAngles[i] += figures.SmallestAngle < 10.0 * static_cast<double>(i + 1) ? 1 : 0;
  }
}
}

Triangles Welded(const Triangles& triangles)
{
  std::vector<std::int32_t> order(triangles.Points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](std::int32_t i) { return triangles.Points[static_cast<std::size_t>(i)]; };
  std::stable_sort(
    order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return at(a) < at(b); });
  std::vector<std::int32_t> same(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isRepeated = i > 0 && at(order[i]) == at(order[i - 1]);
    same[static_cast<std::size_t>(order[i])] =
      isRepeated ? same[static_cast<std::size_t>(order[i - 1])] : order[i];
  }
  Triangles welded = triangles;
  for (auto& corners : welded.Corners)
  {
    for (auto& corner : corners)
    {
      corner = same[static_cast<std::size_t>(corner)];
    }
  }
  return welded;
}

Shape MeasureShape(const Triangles& welded)
{
  Shape shape;
  std::vector<Corners> proper;
  for (const auto& corners : welded.Corners)
  {
    AddFigures(FiguresOf(welded, corners), shape);
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
    {
      proper.push_back(corners);
    }
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, welded.Corners.size()));
  shape.Quality /= count;
  shape.BadFraction /= count;
  shape.EulerNumber = static_cast<std::int64_t>(proper.size());
  Sets fans(3 * proper.size());
  std::vector<char> isNonManifold(welded.Points.size(), 0);
  WalkEdges(proper, shape, fans, isNonManifold);
  WalkPoints(proper, shape, fans, isNonManifold);
  return shape;
}
