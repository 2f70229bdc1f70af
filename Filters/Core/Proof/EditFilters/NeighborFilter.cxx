// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NeighborFilter.h"

#include <algorithm>

namespace bonedecimate
{
Decision NeighborFilter::Check(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending&) const
{
  const std::vector<SurfaceChange::Face>& faces = change.NewFaces;
  const bool isNear = std::any_of(faces.begin(), faces.end(),
    [this](const SurfaceChange::Face& face)
    { return MayComeNear(*this->Neighbors.Others, face.Corners, this->Neighbors.Distance); });
  return isNear ? Decision(Rejection::Constrained) : Decision::Accept();
}
}
