// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridDirection.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr std::size_t MaxGroups = 40;
constexpr std::size_t MaxDirections = 32;
/// Largest difference of equal edges as a fraction of their length.
constexpr double SameEdge = 0.01;
/// Largest cosine between axes, of means over many edges.
constexpr double Perpendicular = 1e-3;

struct EdgeGroup
{
  Vector3 First;                 // mm
  Vector3 Sum = Vector3::Zero(); // mm
  double Count = 0.0;

  Vector3 Axis() const { return this->Sum.normalized(); }
};

/// Empty if there are too many for a binary surface.
std::vector<EdgeGroup> GroupEdges(const Surface& surface)
{
  std::vector<EdgeGroup> groups;
  for (const Triangle& c : surface.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector3 edge = surface.Points[c[(k + 1) % 3]] - surface.Points[c[k]];
      if (edge.squaredNorm() == 0.0)
      {
        continue;
      }
      const double limit = SameEdge * SameEdge * edge.squaredNorm();
      auto group = std::find_if(groups.begin(), groups.end(),
        [&](const EdgeGroup& g) {
          return std::min((g.First - edge).squaredNorm(), (g.First + edge).squaredNorm()) <= limit;
        });
      if (group == groups.end())
      {
        if (groups.size() == MaxGroups)
        {
          return {};
        }
        groups.push_back({ edge });
        group = groups.end() - 1;
      }
      group->Sum += Dot(group->First, edge) < 0.0 ? Vector3(-edge) : edge;
      group->Count += 1.0;
    }
  }
  std::stable_sort(groups.begin(), groups.end(),
    [](const EdgeGroup& a, const EdgeGroup& b) { return a.Count > b.Count; });
  return groups;
}

/// Right-handed and orthogonal to rounding.
Eigen::Matrix3d RotationOf(const Vector3& x, const Vector3& y)
{
  Eigen::Matrix3d rotation;
  rotation.col(0) = x;
  rotation.col(2) = x.cross(y).normalized();
  rotation.col(1) = rotation.col(2).cross(x);
  return rotation;
}
}

std::vector<Eigen::Matrix3d> FindGridDirections(const Surface& surface)
{
  const std::vector<EdgeGroup> groups = GroupEdges(surface);
  std::vector<Eigen::Matrix3d> directions;
  const auto areApart = [&](std::size_t a, std::size_t b)
  { return std::abs(Dot(groups[a].Axis(), groups[b].Axis())) <= Perpendicular; };
  for (std::size_t k = 2; k < groups.size(); ++k)
  {
    for (std::size_t j = 1; j < k; ++j)
    {
      for (std::size_t i = 0; i < j && directions.size() < MaxDirections; ++i)
      {
        if (areApart(i, j) && areApart(j, k) && areApart(i, k))
        {
          directions.push_back(RotationOf(groups[i].Axis(), groups[j].Axis()));
        }
      }
    }
  }
  return directions;
}
}
