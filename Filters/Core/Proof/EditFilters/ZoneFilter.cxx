// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ZoneFilter.h"

#include <algorithm>

namespace bonedecimate
{
Decision ZoneFilter::Screen(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending&) const
{
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    for (std::size_t i = 0; i < 3 && this->AllowedZone; ++i)
    {
      if (!this->AllowedZone->Contains(face.Corners[i]) && !mesh.IsConstrained(face.Vertices[i]))
      {
        return Rejection::Constrained;
      }
    }
  }
  return Decision::Accept();
}

//------------------------------------------------------------------------------
Decision ZoneFilter::Check(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending&) const
{
  const std::vector<SurfaceChange::Face>& faces = change.NewFaces;
  const bool isNear = this->Neighbors.Others &&
    std::any_of(faces.begin(), faces.end(),
      [this](const SurfaceChange::Face& face)
      { return MayComeNear(*this->Neighbors.Others, face.Corners, this->Neighbors.Distance); });
  return isNear ? Decision(Rejection::Constrained) : Decision::Accept();
}
}
