// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InsideOut.h"

#include "Mesh/Statistics.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
struct ClosedComponent
{
  bool IsClosed = true;
  double Volume = 0.0; // mm^3
  Index Triangle = None;
  Eigen::AlignedBox3d Box;
};

std::vector<ClosedComponent> ComponentsOf(const Surface& surface, const std::vector<bool>& isOpen)
{
  const Components found = FindComponents(surface);
  std::vector<ClosedComponent> components(static_cast<std::size_t>(found.Count));
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& corners = surface.Triangles[t];
    const auto number =
      static_cast<std::size_t>(found.OfPoint[static_cast<std::size_t>(corners[0])]);
    ClosedComponent& component = components[number];
    std::array<Vector3, 3> positions;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto point = static_cast<std::size_t>(corners[i]);
      positions[i] = surface.Points[point];
      component.Box.extend(positions[i]);
      component.IsClosed = component.IsClosed && !isOpen[point];
    }
    component.Volume += Dot(positions[0], positions[1].cross(positions[2])) / 6.0;
    component.Triangle = component.Triangle == None ? static_cast<Index>(t) : component.Triangle;
  }
  return components;
}
}

std::vector<Index> FindInsideOut(const Surface& surface, const std::vector<bool>& isOpen)
{
  std::vector<ClosedComponent> components = ComponentsOf(surface, isOpen);
  components.erase(std::remove_if(components.begin(), components.end(),
                     [](const ClosedComponent& component) { return !component.IsClosed; }),
    components.end());
  std::sort(components.begin(), components.end(),
    [](const ClosedComponent& a, const ClosedComponent& b)
    { return std::abs(a.Volume) > std::abs(b.Volume); });
  constexpr std::size_t mostSurrounding = 64; // number of larger components that are tested
  std::vector<const ClosedComponent*> outer;
  std::vector<Index> triangles;
  for (const ClosedComponent& component : components)
  {
    if (component.Volume >= 0.0)
    {
      if (outer.size() < mostSurrounding)
      {
        outer.push_back(&component);
      }
      continue;
    }
    const bool isCavity = std::any_of(outer.begin(), outer.end(),
      [&component](const ClosedComponent* other) { return other->Box.contains(component.Box); });
    if (!isCavity)
    {
      triangles.push_back(component.Triangle);
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}
}
