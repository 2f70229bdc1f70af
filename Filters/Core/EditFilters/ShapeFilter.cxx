// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeFilter.h"

#include "Geometry/SmallestAngle.h"

namespace bonedecimate
{
Decision ShapeFilter::Screen(
  const HalfEdgeMesh& mesh, const ProposedEdit& edit, EditFilter::Pending&) const
{
  double after = this->LargestCosine;
  for (const SurfaceChange::Face& face : edit.Change.NewFaces)
  {
    const auto& [a, b, c] = face.Corners;
    after = std::max(after, CosineOfSmallestAngle(a, b, c));
  }
  if (!(after > this->LargestCosine))
  {
    return Decision::Accept();
  }
  for (const Index face : edit.Change.OldFaces)
  {
    const Triangle v = mesh.Corners(face);
    if (CosineOfSmallestAngle(mesh.Position(v[0]), mesh.Position(v[1]), mesh.Position(v[2])) >=
      after)
    {
      return Decision::Accept();
    }
  }
  return Rejection::Shape;
}
}
