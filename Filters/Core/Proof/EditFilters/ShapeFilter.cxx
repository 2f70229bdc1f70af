// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeFilter.h"

#include "Geometry/SmallestAngle.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
double SquareOfLongestSide(const Vector3& a, const Vector3& b, const Vector3& c) // mm^2
{
  return std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
}

/// @param measure Function of the vertices and corners of a triangle; larger is worse.
template <typename Measure>
bool IsAllowed(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, double limit, const Measure& measure)
{
  double after = limit;
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    after = std::max(after, measure(face.Vertices, face.Corners));
  }
  bool isAllowed = !(after > limit);
  for (std::size_t i = 0; i < change.OldFaces.size() && !isAllowed; ++i)
  {
    const FaceId face = change.OldFaces[i];
    isAllowed = measure(mesh.Corners(face), PositionsOf(mesh, face)) >= after;
  }
  return isAllowed;
}
}

Decision ShapeFilter::Screen(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending&) const
{
  const bool isSplit = change.Requested.Kind == EditKind::Split;
  const bool isAllowed = isSplit ||
    ((!this->Limits.LimitsAngles() || this->KeepsAngles(mesh, change)) &&
      (!this->Limits.LimitsEdges() || this->KeepsLengths(mesh, change)));
  return isAllowed ? Rejection::NotRejected : Rejection::Shape;
}

//------------------------------------------------------------------------------
bool ShapeFilter::KeepsAngles(const HalfEdgeMesh& mesh, const SurfaceChange& change) const
{
  return IsAllowed(mesh, change, this->Limits.MaxCosine,
    [](const Triangle&, const Corners& at) { return CosineOfSmallestAngle(at[0], at[1], at[2]); });
}

//------------------------------------------------------------------------------
bool ShapeFilter::KeepsLengths(const HalfEdgeMesh& mesh, const SurfaceChange& change) const
{
  if (this->Limits.Sizing)
  {
    return IsAllowed(mesh, change, ShapeLimits::SplitRatio * ShapeLimits::SplitRatio,
      [this](const Triangle& vertices, const Corners& at)
      { return this->SquareOfLongestRatio(vertices, at); });
  }
  const double longest = this->Limits.SplitLength();
  return IsAllowed(mesh, change, longest * longest,
    [](const Triangle&, const Corners& at) { return SquareOfLongestSide(at[0], at[1], at[2]); });
}

//------------------------------------------------------------------------------
/// The square of the largest ratio of a side to its local length; 0 if no side is longer than
/// allowed anywhere.
double ShapeFilter::SquareOfLongestRatio(const Triangle& vertices, const Corners& at) const
{
  const double least = this->Limits.MinSplitLength();
  if (SquareOfLongestSide(at[0], at[1], at[2]) <= least * least)
  {
    return 0.0;
  }
  std::array<double, 3> lengths{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    lengths[k] = this->Lengths.At(vertices[k], at[k]);
  }
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t next = (k + 1) % 3;
    const double length = std::min(lengths[k], lengths[next]);
    largest = std::max(largest, (at[next] - at[k]).squaredNorm() / (length * length));
  }
  return largest;
}

//------------------------------------------------------------------------------
void ShapeFilter::Commit(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending&, Tally&)
{
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    for (std::size_t k = 0; k < 3 && this->Limits.Sizing; ++k)
    {
      this->Lengths.Update(face.Vertices[k], face.Corners[k]);
    }
  }
}
}
