// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgesByLength.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
std::vector<EdgeOfLength> EdgesByLength(const HalfEdgeMesh& mesh, double above, double below)
{
  const double least = above < 0.0 ? -1.0 : above * above;
  std::vector<EdgeOfLength> edges;
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    for (Index k = 0; k < 3 && mesh.IsAlive(face); ++k)
    {
      const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, k);
      const double square = SquaredLength(mesh, h);
      const bool isFirst = mesh.Twin(h) == None || h < mesh.Twin(h);
      if (isFirst && square > least && square < below * below)
      {
        edges.push_back({ square, h });
      }
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const EdgeOfLength& a, const EdgeOfLength& b)
    {
      return std::pair<double, Index>(a.SquaredLength, a.Edge) <
        std::pair<double, Index>(b.SquaredLength, b.Edge);
    });
  return edges;
}
}
