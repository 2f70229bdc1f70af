// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GapRule.h"

#include "Base/Parallel.h"
#include "Geometry/TriangleGeometry.h"
#include "PartTree.h"

namespace bonedecimate
{
namespace
{
std::vector<Vector3> NormalsOf(const Surface& surface)
{
  std::vector<Vector3> normals(surface.Points.size(), Vector3::Zero());
  for (const Triangle& c : surface.Triangles)
  {
    const Vector3 area =
      AreaVector(surface.Points[c[0]], surface.Points[c[1]], surface.Points[c[2]]);
    for (const Index point : c)
    {
      normals[point] += area;
    }
  }
  return normals;
}

/// Infinite if it is not less than the limit.
float Below(double width, double limit)
{
  return width < limit ? static_cast<float>(width) : std::numeric_limits<float>::infinity();
}
}

GapRule::GapRule(const Surface& surface, double limit, int threads, const Monitor& monitor)
  : Parts(FindComponents(surface))
  , Widths(surface.Points.size())
{
  if (!(limit > 0.0))
  {
    return;
  }
  const PartTree tree(surface, this->Parts);
  const std::vector<Vector3> normals = NormalsOf(surface);
  const auto measure = [&](Index point)
  {
    const Index part = this->Parts.OfPoint[point];
    Gap& gap = this->Widths[point];
    gap.ToOwn = Below(tree.ToFacing(point, normals[point].normalized(), limit), limit);
    if (this->Parts.Count > 1)
    {
      gap.ToOther = Below(tree.ToOtherPart(surface.Points[point], part, limit), limit);
    }
  };
  ForEachChunk(surface.Points.size(), threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        measure(static_cast<Index>(i));
      }
    });
}

double MinFragmentGap(const Surface& surface)
{
  const Components parts = FindComponents(surface);
  return parts.Count > 1 ? PartTree(surface, parts).MinFragmentGap()
                         : std::numeric_limits<double>::infinity();
}
}
