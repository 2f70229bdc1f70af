// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels.h"

#include "Geometry/TriangleGeometry.h"
#include "Mesh/Cleaning.h"

#include <algorithm>

namespace bonedecimate
{
std::vector<Index> LabelsOf(const CleanSurface& clean, const Labels& labels)
{
  std::vector<Index> ofFace;
  ofFace.reserve(clean.InputTriangle.size());
  for (const Index triangle : clean.InputTriangle)
  {
    ofFace.push_back(labels.OfTriangle[static_cast<std::size_t>(triangle)]);
  }
  return ofFace;
}

//------------------------------------------------------------------------------
std::vector<LabelArea> LabelAreas(
  const CleanSurface& clean, const HalfEdgeMesh& mesh, const Labels& labels)
{
  std::vector<LabelArea> areas;
  areas.reserve(labels.Names.size());
  for (const std::string& name : labels.Names)
  {
    areas.push_back({ name, 0.0, 0.0 });
  }
  const std::vector<Index> ofFace = LabelsOf(clean, labels);
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    LabelArea& area = areas[static_cast<std::size_t>(ofFace[face])];
    const Triangle& first = clean.Surface.Triangles[face];
    const std::vector<Vector3>& points = clean.Surface.Points;
    area.Input += AreaVector(points[first[0]], points[first[1]], points[first[2]]).norm();
    if (mesh.IsAlive(face))
    {
      const Triangle c = mesh.Corners(face);
      area.Output +=
        AreaVector(mesh.Position(c[0]), mesh.Position(c[1]), mesh.Position(c[2])).norm();
    }
  }
  return areas;
}
}
