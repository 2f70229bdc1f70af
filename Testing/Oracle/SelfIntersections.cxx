// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Uses CGAL's Box_intersection_d (GPL-3.0-or-later), which makes the program built from it GPL: a
// tool of the tests, never installed. CGAL::Polygon_mesh_processing::self_intersections requires a
// manifold surface; this accepts any triangles and tests each pair by the same rules.
#include "SelfIntersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corners = std::array<std::int32_t, 3>;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

class PairTest
{
public:
  explicit PairTest(const Triangles& surface)
    : Surface(surface)
  {
  }

  Kernel::Triangle_3 Facet(const Corners& t) const
  {
    return { this->At(t[0]), this->At(t[1]), this->At(t[2]) };
  }

  bool Intersect(const Corners& a, const Corners& b) const
  {
    std::vector<std::int32_t> shared;
    std::copy_if(a.begin(), a.end(), std::back_inserter(shared),
      [&](std::int32_t p) { return std::find(b.begin(), b.end(), p) != b.end(); });
    switch (shared.size())
    {
      case 0:
        return CGAL::do_intersect(this->Facet(a), this->Facet(b));
      case 1:
        return CGAL::do_intersect(this->Facet(a), this->Opposite(b, shared[0])) ||
          CGAL::do_intersect(this->Facet(b), this->Opposite(a, shared[0]));
      case 2:
        return this->OverlapBeyondEdge(a, b, shared);
      default:
        return true;
    }
  }

private:
  Kernel::Point_3 At(std::int32_t point) const
  {
    const auto& x = this->Surface.Points[static_cast<std::size_t>(point)];
    return { x[0], x[1], x[2] };
  }

  Kernel::Segment_3 Opposite(const Corners& t, std::int32_t point) const
  {
    const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), point) - t.begin());
    return { this->At(t[(k + 1) % 3]), this->At(t[(k + 2) % 3]) };
  }

  /// Whether they are folded flat onto each other along their common edge.
  bool OverlapBeyondEdge(
    const Corners& a, const Corners& b, const std::vector<std::int32_t>& edge) const
  {
    const auto third = [&](const Corners& t)
    { return this->At(t[0] + t[1] + t[2] - edge[0] - edge[1]); };
    const Kernel::Point_3 p = this->At(edge[0]);
    const Kernel::Point_3 q = this->At(edge[1]);
    return CGAL::coplanar(p, q, third(a), third(b)) &&
      CGAL::coplanar_orientation(p, q, third(a), third(b)) == CGAL::POSITIVE;
  }

  const Triangles& Surface;
};
}

std::int64_t CountSelfIntersections(const Triangles& welded)
{
  const PairTest test(welded);
  std::vector<Box> boxes;
  for (std::size_t t = 0; t < welded.Corners.size(); ++t)
  {
    const Kernel::Triangle_3 facet = test.Facet(welded.Corners[t]);
    if (!facet.is_degenerate())
    {
      boxes.emplace_back(facet.bbox(), t);
    }
  }
  std::int64_t pairs = 0;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
    [&](const Box& a, const Box& b)
    { pairs += test.Intersect(welded.Corners[a.info()], welded.Corners[b.info()]) ? 1 : 0; });
  return pairs;
}
