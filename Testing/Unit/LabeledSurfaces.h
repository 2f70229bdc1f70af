// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabeledSurfaces.h
 * @brief Surfaces with labels and the curves between labels, found by brute force.
 */
#ifndef BoneDecimate_Testing_LabeledSurfaces_h
#define BoneDecimate_Testing_LabeledSurfaces_h

#include "BruteForce.h"
#include "Geometry/TriangleGeometry.h"
#include "Run/Decimate.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace bonedecimate::testsupport
{
using Segment = std::array<Vector3, 2>;

/// The triangles at each edge.
inline std::map<std::pair<Index, Index>, std::vector<Index>> EdgesOf(const Surface& surface)
{
  std::map<std::pair<Index, Index>, std::vector<Index>> edges;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& c = surface.Triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
    {
      edges[std::minmax(c[k], c[(k + 1) % 3])].push_back(static_cast<Index>(t));
    }
  }
  return edges;
}

/// Labels of the parts connected by edges of two triangles: for a halved ball both halves of the skin and the wall.
inline Labels PatchesAsLabels(const Surface& surface)
{
  std::vector<std::vector<Index>> neighbors(surface.Triangles.size());
  for (const auto& [edge, triangles] : EdgesOf(surface))
  {
    if (triangles.size() == 2)
    {
      neighbors[triangles[0]].push_back(triangles[1]);
      neighbors[triangles[1]].push_back(triangles[0]);
    }
  }
  Labels labels;
  labels.OfTriangle.assign(surface.Triangles.size(), None);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    std::vector<Index> open;
    if (labels.OfTriangle[t] == None)
    {
      open = { static_cast<Index>(t) };
      labels.OfTriangle[t] = static_cast<Index>(labels.Names.size());
      labels.Names.push_back(std::to_string(labels.Names.size()));
    }
    while (!open.empty())
    {
      const Index at = open.back();
      open.pop_back();
      for (const Index next : neighbors[at])
      {
        if (labels.OfTriangle[next] == None)
        {
          labels.OfTriangle[next] = labels.OfTriangle[at];
          open.push_back(next);
        }
      }
    }
  }
  return labels;
}

/// Three labels that meet in two points of a ball.
inline Labels ThreeParts(const Surface& surface)
{
  Labels labels;
  labels.Names = { "left", "right", "top" };
  for (const Triangle& t : surface.Triangles)
  {
    const Vector3 sum = surface.Points[t[0]] + surface.Points[t[1]] + surface.Points[t[2]];
    labels.OfTriangle.push_back(sum[2] > 4.0 ? 2 : sum[0] + 0.3 * sum[1] > 0.0 ? 1 : 0);
  }
  return labels;
}

inline Result RunWith(const Labels& labels, const Surface& input, const Options& options)
{
  return Decimate(input, options, {}, { false, true, nullptr, nullptr, &labels });
}

/// The label of each output triangle.
inline std::vector<Index> LabelsAfter(const Labels& labels, const Result& result)
{
  std::vector<Index> after;
  for (const Index triangle : result.Origins.TriangleAtCentroid)
  {
    after.push_back(labels.OfTriangle[triangle]);
  }
  return after;
}

/// Edges between labels, and those of more than two triangles.
inline std::vector<Segment> LinesOf(const Surface& surface, const std::vector<Index>& labels)
{
  std::vector<Segment> lines;
  for (const auto& [edge, triangles] : EdgesOf(surface))
  {
    const bool isLine = triangles.size() > 2 ||
      std::any_of(triangles.begin(), triangles.end(),
        [&, first = triangles[0]](Index t) { return labels[t] != labels[first]; });
    if (isLine)
    {
      lines.push_back({ surface.Points[edge.first], surface.Points[edge.second] });
    }
  }
  return lines;
}

/// mm, the largest distance of points on each curve to the nearest other curve.
inline double MaxDistance(const std::vector<Segment>& from, const std::vector<Segment>& to)
{
  double largest = 0.0;
  for (const Segment& segment : from)
  {
    for (const double t : { 0.0, 0.25, 0.5, 0.75, 1.0 })
    {
      const Vector3 p = segment[0] + t * (segment[1] - segment[0]);
      double least = std::numeric_limits<double>::infinity();
      for (const Segment& other : to)
      {
        const double s = NearestFraction(p, other[0], other[1]);
        least = std::min(least, (other[0] + s * (other[1] - other[0]) - p).norm());
      }
      largest = std::max(largest, least);
    }
  }
  return largest;
}

using Coordinates = std::array<double, 3>;

inline std::set<Coordinates> EndsOf(const std::vector<Segment>& lines)
{
  std::set<Coordinates> positions;
  for (const Segment& segment : lines)
  {
    for (const Vector3& p : segment)
    {
      positions.insert({ p[0], p[1], p[2] });
    }
  }
  return positions;
}

/// The triangles of some labels, with the points that they use.
inline Surface PartOfSurface(
  const Surface& surface, const Labels& labels, const std::set<Index>& wanted)
{
  Surface part;
  std::map<Index, Index> names;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    if (wanted.count(labels.OfTriangle[t]) == 0)
    {
      continue;
    }
    Triangle corners = surface.Triangles[t];
    for (Index& corner : corners)
    {
      const auto known = names.emplace(corner, static_cast<Index>(part.Points.size()));
      if (known.second)
      {
        part.Points.push_back(surface.Points[corner]);
      }
      corner = known.first->second;
    }
    part.Triangles.push_back(corners);
  }
  return part;
}

/// Triangles as the coordinates of their corners in any order.
inline std::set<std::set<Coordinates>> PositionsOfTriangles(const Surface& surface)
{
  std::set<std::set<Coordinates>> all;
  for (const Triangle& t : surface.Triangles)
  {
    std::set<Coordinates> corners;
    for (const Index corner : t)
    {
      const Vector3& p = surface.Points[corner];
      corners.insert({ p[0], p[1], p[2] });
    }
    all.insert(corners);
  }
  return all;
}
}

#endif
