// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MissingComponents.h"

#include "Base/Parallel.h"
#include "Geometry/BoundingTree.h"
#include "Mesh/Statistics.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>

namespace bonedecimate
{
namespace
{
/// For each component, whether a point of the result is nearest to it.
std::vector<std::atomic<bool>> FindCounterparts(const Surface& reference,
  const Components& components, const Surface& result, const Vector3& shift, int threads)
{
  const BoundingTree tree(reference, threads);
  std::vector<std::atomic<bool>> found(static_cast<std::size_t>(components.Count));
  const auto mark = [&](const Vector3& p, Index hint)
  {
    const Index triangle = tree.FindNearest(p + shift, hint).Triangle;
    const Index point = reference.Triangles[static_cast<std::size_t>(triangle)][0];
    const Index component = components.OfPoint[static_cast<std::size_t>(point)];
    found[static_cast<std::size_t>(component)].store(true, std::memory_order_relaxed);
    return triangle;
  };
  ForEachBlock(result.Triangles.size(), threads,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Index hint = None;
      for (std::size_t i = first; i < last; ++i)
      {
        Vector3 sum = Vector3::Zero();
        for (const Index corner : result.Triangles[i])
        {
          const Vector3& p = result.Points[static_cast<std::size_t>(corner)];
          hint = mark(p, hint);
          sum += p;
        }
        hint = mark(sum / 3.0, hint);
      }
    });
  return found;
}
}

std::vector<MissingComponent> FindMissing(const Surface& reference, const Surface& result,
  const Vector3& shift, const Vector3& origin, int threads)
{
  const Components components = FindComponents(reference);
  if (components.Count < 2)
  {
    return {};
  }
  const auto found = FindCounterparts(reference, components, result, shift, threads);
  std::vector<Eigen::AlignedBox3d> boxes(found.size());
  std::vector<MissingComponent> all(found.size());
  for (const Triangle& triangle : reference.Triangles)
  {
    const auto component =
      static_cast<std::size_t>(components.OfPoint[static_cast<std::size_t>(triangle[0])]);
    ++all[component].Triangles;
    for (const Index corner : triangle)
    {
      boxes[component].extend(reference.Points[static_cast<std::size_t>(corner)] + origin);
    }
  }
  std::vector<MissingComponent> missing;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (!found[i])
    {
      const Vector3 center = boxes[i].center();
      all[i].Diagonal = boxes[i].diagonal().norm();
      all[i].Center = { center.x(), center.y(), center.z() };
      missing.push_back(all[i]);
    }
  }
  std::stable_sort(missing.begin(), missing.end(),
    [](const MissingComponent& a, const MissingComponent& b) { return a.Diagonal > b.Diagonal; });
  return missing;
}
}
