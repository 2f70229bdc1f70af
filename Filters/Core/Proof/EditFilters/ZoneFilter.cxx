// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ZoneFilter.h"

namespace bonedecimate
{
Decision ZoneFilter::Screen(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending&) const
{
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (!this->Inside.Contains(face.Corners[i]) && !mesh.IsConstrained(face.Vertices[i]))
      {
        return Rejection::Constrained;
      }
    }
  }
  return Decision::Accept();
}
}
