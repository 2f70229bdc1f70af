// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CapTriangles.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Whether the triangles have exactly the edges of the loops as their boundary, in the same
/// direction.
bool AreBoundedBy(std::set<PointPair> boundary, const std::vector<Triangle>& triangles)
{
  std::set<PointPair> edges;
  for (const Triangle& corners : triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (!edges.insert({ corners[k], corners[(k + 1) % 3] }).second)
      {
        return false;
      }
    }
  }
  for (const PointPair& edge : edges)
  {
    const bool isInside = edges.count({ edge.second, edge.first }) > 0;
    if (isInside == (boundary.erase(edge) > 0))
    {
      return false;
    }
  }
  return boundary.empty();
}

/// Replaces ids of contours by those of the surface; none if one is out of range.
std::vector<Triangle> WithIdsOf(std::vector<Triangle> triangles, const std::vector<Index>& points)
{
  const auto count = static_cast<Index>(points.size());
  for (Triangle& corners : triangles)
  {
    for (Index& corner : corners)
    {
      if (corner < 0 || corner >= count)
      {
        return {};
      }
      corner = points[static_cast<std::size_t>(corner)];
    }
  }
  return triangles;
}

/// Adds all edges, including those of loops, which no other cap can have.
void AddChords(const std::vector<Triangle>& triangles, std::set<PointPair>& chords)
{
  for (const Triangle& corners : triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      chords.insert(std::minmax(corners[k], corners[(k + 1) % 3]));
    }
  }
}

/// The first side of a triangle that is among the chords; nothing if there is none.
std::optional<std::pair<std::size_t, std::size_t>> FindChord(
  const std::vector<Triangle>& triangles, const std::set<PointPair>& chords)
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (chords.count(std::minmax(triangles[t][k], triangles[t][(k + 1) % 3])) > 0)
      {
        return std::make_pair(t, k);
      }
    }
  }
  return std::nullopt;
}

/// Splits the triangle that has the side from-to at a point on this side, if there is one.
void Divide(
  Index from, Index to, Index middle, std::vector<Triangle>& triangles, std::vector<Triangle>& more)
{
  for (Triangle& corners : triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (corners[k] == from && corners[(k + 1) % 3] == to)
      {
        const Index apex = corners[(k + 2) % 3];
        corners = { from, middle, apex };
        more.push_back({ middle, to, apex });
        return;
      }
    }
  }
}

/// Splits each edge of a cap that the surface already has in the middle.
void SplitChords(Surface& surface, BoundaryLoops& found, std::vector<Triangle>& triangles)
{
  while (const auto side = FindChord(triangles, found.Chords))
  {
    const Index a = triangles[side->first][side->second];
    const Index b = triangles[side->first][(side->second + 1) % 3];
    const auto middle = static_cast<Index>(surface.Points.size());
    surface.Points.emplace_back(0.5 *
      (surface.Points[static_cast<std::size_t>(a)] + surface.Points[static_cast<std::size_t>(b)]));
    found.SplitEdges.emplace_back(a, b);
    std::vector<Triangle> more;
    Divide(a, b, middle, triangles, more);
    Divide(b, a, middle, triangles, more);
    triangles.insert(triangles.end(), more.begin(), more.end());
  }
}

/// Connected triangles, with the loops at their points.
std::vector<Cap> Pieces(const std::vector<Triangle>& triangles,
  const std::vector<BoundaryLoop>& loops, const std::vector<std::size_t>& group)
{
  std::map<Index, Index> leader;
  const auto find = [&leader](Index point)
  {
    while (leader.emplace(point, point).first->second != point)
    {
      point = leader[point];
    }
    return point;
  };
  for (const Triangle& corners : triangles)
  {
    leader[find(corners[1])] = find(corners[0]);
    leader[find(corners[2])] = find(corners[0]);
  }
  std::map<Index, Cap> pieces;
  for (const Triangle& corners : triangles)
  {
    pieces[find(corners[0])].Triangles.push_back(corners);
  }
  std::vector<Cap> caps;
  for (const std::size_t loop : group)
  {
    pieces[find(loops[loop].Points.front())].Loops.push_back(loop);
  }
  caps.reserve(pieces.size());
  for (auto& [point, cap] : pieces)
  {
    caps.push_back(std::move(cap));
  }
  return caps;
}
}

std::vector<Cap> FillLoops(Surface& surface, BoundaryLoops& found,
  const std::vector<std::size_t>& group, const ContourTriangulator& triangulate)
{
  Contours contours;
  std::vector<Index> ids; // of the surface
  std::set<PointPair> boundary;
  Vector3 area = Vector3::Zero();
  for (const std::size_t loop : group)
  {
    const std::vector<Index>& chain = found.Loops[loop].Points;
    contours.Starts.push_back(static_cast<Index>(ids.size()));
    for (std::size_t i = 0; i < chain.size(); ++i)
    {
      contours.Points.push_back(surface.Points[static_cast<std::size_t>(chain[i])]);
      boundary.insert({ chain[i], chain[(i + 1) % chain.size()] });
    }
    ids.insert(ids.end(), chain.begin(), chain.end());
    area += found.Loops[loop].Area;
  }
  contours.Starts.push_back(static_cast<Index>(ids.size()));
  contours.Normal = area.normalized();
  const std::vector<Triangle> triangles = WithIdsOf(triangulate(contours), ids);
  std::vector<Cap> caps;
  if (!AreBoundedBy(std::move(boundary), triangles))
  {
    return caps;
  }
  for (Cap& cap : Pieces(triangles, found.Loops, group))
  {
    SplitChords(surface, found, cap.Triangles);
    AddChords(cap.Triangles, found.Chords);
    caps.push_back(std::move(cap));
  }
  return caps;
}
}
