// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GapRule.h"

#include "Base/Parallel.h"
#include "FragmentTree.h"
#include "Geometry/TriangleGeometry.h"

namespace bonedecimate
{
namespace
{
/// Infinite if it is not less than the limit.
float Below(double width, double limit)
{
  return width < limit ? static_cast<float>(width) : std::numeric_limits<float>::infinity();
}
}

GapRule::GapRule(const Surface& surface, double limit, int threads, const Monitor& monitor)
  : Fragments(FindComponents(surface))
  , Widths(surface.Points.size())
{
  if (!(limit > 0.0))
  {
    return;
  }
  const FragmentTree tree(surface, this->Fragments);
  const std::vector<Vector3> normals = AreaNormals(surface.Points, surface.Triangles);
  const auto measure = [&](Index point)
  {
    const Index fragment = this->Fragments.OfPoint[point];
    Gap& gap = this->Widths[point];
    gap.WithinFragment =
      Below(tree.DistanceToFacing(point, normals[point].normalized(), limit), limit);
    if (this->Fragments.Count > 1)
    {
      gap.BetweenFragments =
        Below(tree.DistanceToOther(surface.Points[point], fragment, limit), limit);
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
  const Components fragments = FindComponents(surface);
  return fragments.Count > 1 ? FragmentTree(surface, fragments).MinFragmentGap()
                             : std::numeric_limits<double>::infinity();
}
}
