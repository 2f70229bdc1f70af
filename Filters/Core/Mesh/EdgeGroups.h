// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeGroups.h
 * @brief Which half-edges of a triangle list lie on the same edge.
 *
 * Half-edge 3 t + k runs from corner k of triangle t to the next corner.
 */
#ifndef BoneDecimate_Core_Mesh_EdgeGroups_h
#define BoneDecimate_Core_Mesh_EdgeGroups_h

#include "Surface.h"

#include <algorithm>
#include <vector>

namespace bonedecimate
{
inline Index HalfEdgeOrigin(const std::vector<Triangle>& triangles, Index halfEdge)
{
  return triangles[halfEdge / 3][halfEdge % 3];
}

inline Index HalfEdgeTarget(const std::vector<Triangle>& triangles, Index halfEdge)
{
  return triangles[halfEdge / 3][(halfEdge + 1) % 3];
}

/**
 * Calls visit(first, last) for every edge, where [first, last) are pointers to its half-edges in ascending order.
 * Edges come in ascending order of their lesser and then their greater point.
 */
template <typename Visit>
void VisitEdgeGroups(
  const std::vector<Triangle>& triangles, std::size_t numberOfPoints, Visit visit)
{
  struct Entry
  {
    Index Greater;
    Index HalfEdge;
  };
  const Index count = static_cast<Index>(3 * triangles.size());
  // Counting sort by the lesser point: buckets of about three half-edges.
  std::vector<Index> start(numberOfPoints + 1, 0);
  const auto lesser = [&](Index h)
  { return std::min(HalfEdgeOrigin(triangles, h), HalfEdgeTarget(triangles, h)); };
  for (Index h = 0; h < count; ++h)
  {
    ++start[lesser(h) + 1];
  }
  for (std::size_t p = 0; p < numberOfPoints; ++p)
  {
    start[p + 1] += start[p];
  }
  std::vector<Entry> entries(static_cast<std::size_t>(count));
  std::vector<Index> next(start.begin(), start.end() - 1);
  for (Index h = 0; h < count; ++h)
  {
    const Index greater = std::max(HalfEdgeOrigin(triangles, h), HalfEdgeTarget(triangles, h));
    entries[next[lesser(h)]++] = { greater, h };
  }
  std::vector<Index> group;
  for (std::size_t p = 0; p < numberOfPoints; ++p)
  {
    const auto first = entries.begin() + start[p];
    const auto last = entries.begin() + start[p + 1];
    std::sort(first, last,
      [](const Entry& a, const Entry& b)
      { return a.Greater != b.Greater ? a.Greater < b.Greater : a.HalfEdge < b.HalfEdge; });
    for (auto at = first; at != last;)
    {
      group.clear();
      const Index greater = at->Greater;
      for (; at != last && at->Greater == greater; ++at)
      {
        group.push_back(at->HalfEdge);
      }
      visit(group.data(), group.data() + group.size());
    }
  }
}
}

#endif
