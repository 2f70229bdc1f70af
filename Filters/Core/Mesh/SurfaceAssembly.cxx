// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceAssembly.h"

namespace bonedecimate
{
std::vector<Index> NumberVertices(
  std::size_t vertexSlots, std::vector<Triangle>& triangles, int threads)
{
  std::vector<Index> number(vertexSlots, None);
  for (const Triangle& corners : triangles)
  {
    number[corners[0]] = number[corners[1]] = number[corners[2]] = 0;
  }
  std::vector<Index> vertices;
  vertices.reserve(triangles.size());
  for (std::size_t v = 0; v < vertexSlots; ++v)
  {
    if (number[v] != None)
    {
      number[v] = static_cast<Index>(vertices.size());
      vertices.push_back(static_cast<Index>(v));
    }
  }
  ForEachId(triangles.size(), threads,
    [&](std::size_t t)
    {
      Triangle& c = triangles[t];
      c = { number[c[0]], number[c[1]], number[c[2]] };
    });
  return vertices;
}

//------------------------------------------------------------------------------
Vector3 OutputPosition(const Surface& input, const CleanSurface& clean, VertexId vertex,
  const Vector3& local, const PointRounding& rounding)
{
  const auto v = static_cast<std::size_t>(vertex);
  const bool hasMoved = local != clean.Surface.Points[v];
  const Vector3 position = hasMoved ? Vector3(local + clean.Origin)
                                    : input.Points[static_cast<std::size_t>(clean.InputPoint[v])];
  return rounding.Of(position);
}
}
