// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SingleLabel.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Corner k of triangle t is 3 t + k; its edge runs from it to the next corner of the triangle.
using Corner = std::size_t;

Corner NextCorner(Corner corner)
{
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// Fans of triangles: corners at one vertex whose triangles are neighbors belong together.
class Fans
{
public:
  explicit Fans(const std::vector<Triangle>& triangles)
    : Triangles(triangles)
    , Sets(3 * triangles.size())
  {
    this->JoinNeighbors();
  }

  /// The least corner of the fan.
  Corner FirstOf(Corner corner) { return this->Sets.Root(corner); }

private:
  struct Edge
  {
    Index Low;
    Index High;
    Corner StartCorner;
  };

  Index PointAt(Corner corner) const { return this->Triangles[corner / 3][corner % 3]; }

  std::vector<Edge> SortedEdges() const
  {
    std::vector<Edge> edges;
    edges.reserve(this->Sets.Size());
    for (Corner corner = 0; corner < this->Sets.Size(); ++corner)
    {
      const auto [low, high] =
        std::minmax({ this->PointAt(corner), this->PointAt(NextCorner(corner)) });
      edges.push_back({ low, high, corner });
    }
    std::sort(edges.begin(), edges.end(),
      [](const Edge& a, const Edge& b)
      { return std::tie(a.Low, a.High, a.StartCorner) < std::tie(b.Low, b.High, b.StartCorner); });
    return edges;
  }

  /// Joins corners across edges of two triangles with opposite directions.
  void JoinNeighbors()
  {
    const std::vector<Edge> edges = this->SortedEdges();
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last)
    {
      while (last < edges.size() && edges[last].Low == edges[first].Low &&
        edges[last].High == edges[first].High)
      {
        ++last;
      }
      if (last - first == 2)
      {
        this->JoinOver(edges[first].StartCorner, edges[first + 1].StartCorner);
      }
    }
  }

  void JoinOver(Corner a, Corner b)
  {
    if (this->PointAt(a) != this->PointAt(b))
    {
      this->Sets.Join(a, NextCorner(b));
      this->Sets.Join(NextCorner(a), b);
    }
  }

  const std::vector<Triangle>& Triangles;
  DisjointSets<Corner> Sets;
};

/// Gives each fan a point of its own.
void AssignPoints(const Surface& surface, SingleLabelSurface& result)
{
  std::vector<Triangle>& triangles = result.Surface.Triangles;
  const std::vector<Triangle> original = triangles;
  Fans fans(original);
  std::vector<Index> ids(3 * triangles.size(), None);
  for (Corner corner = 0; corner < ids.size(); ++corner)
  {
    const Corner first = fans.FirstOf(corner);
    if (first == corner)
    {
      const Index point = original[corner / 3][corner % 3];
      ids[corner] = static_cast<Index>(result.OriginalPoint.size());
      result.OriginalPoint.push_back(point);
      result.Surface.Points.push_back(surface.Points[static_cast<std::size_t>(point)]);
    }
    triangles[corner / 3][corner % 3] = ids[first];
  }
}
}

//------------------------------------------------------------------------------
SingleLabelSurface ExtractLabel(
  const Surface& surface, const std::vector<BoundaryLabels>& labels, Index label)
{
  SingleLabelSurface result;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    Triangle corners = surface.Triangles[t];
    if (labels[t][0] != label && labels[t][1] != label)
    {
      continue;
    }
    if (labels[t][1] == label)
    {
      std::swap(corners[1], corners[2]);
    }
    result.Surface.Triangles.push_back(corners);
    result.OriginalTriangle.push_back(static_cast<Index>(t));
  }
  AssignPoints(surface, result);
  return result;
}
}
