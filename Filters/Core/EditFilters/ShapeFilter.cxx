// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeFilter.h"

#include "Geometry/SmallestAngle.h"

namespace bonedecimate
{
namespace
{
double SquareOfLongestSide(const Vector3& a, const Vector3& b, const Vector3& c) // mm^2
{
  return std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
}

/// @param measure Of the corners of a triangle; larger is worse.
template <typename Measure>
bool IsAllowed(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, double limit, const Measure& measure)
{
  double after = limit;
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    const auto& [a, b, c] = face.Corners;
    after = std::max(after, measure(a, b, c));
  }
  bool isAllowed = !(after > limit);
  for (std::size_t i = 0; i < change.OldFaces.size() && !isAllowed; ++i)
  {
    const Triangle v = mesh.Corners(change.OldFaces[i]);
    isAllowed = measure(mesh.Position(v[0]), mesh.Position(v[1]), mesh.Position(v[2])) >= after;
  }
  return isAllowed;
}
}

Decision ShapeFilter::Screen(
  const HalfEdgeMesh& mesh, const ProposedEdit& edit, EditFilter::Pending&) const
{
  const bool isSplit = edit.Requested.Kind == EditKind::Split;
  const double longest = this->Limits.LongestEdge();
  const bool isAllowed = isSplit ||
    ((!this->Limits.LimitsAngles() ||
       IsAllowed(mesh, edit.Change, this->Limits.LargestCosine, CosineOfSmallestAngle)) &&
      (!this->Limits.LimitsEdges() ||
        IsAllowed(mesh, edit.Change, longest * longest, SquareOfLongestSide)));
  return isAllowed ? Rejection::NotRejected : Rejection::Shape;
}
}
