// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Target.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::certificate
{
namespace
{
/// Represents segments and points by triangles that repeat a corner.
Surface AsTriangles(const Simplices& simplices)
{
  Surface surface{ simplices.Points, simplices.Corners };
  for (Triangle& corners : surface.Triangles)
  {
    corners[1] = corners[1] == None ? corners[0] : corners[1];
    corners[2] = corners[2] == None ? corners[1] : corners[2];
  }
  return surface;
}

/// The largest distance along an axis from p to the bounding box of the corners, mm: a lower bound
/// of the distance.
double DistanceToBox(const Vector3& p, const Corners& corners)
{
  const Vector3 below = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]) - p;
  const Vector3 above = p - corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  return below.cwiseMax(above).maxCoeff();
}

double Squared(double length)
{
  return length > 0.0 ? length * length : 0.0;
}
}

//------------------------------------------------------------------------------
Target::Target(const Simplices& simplices, int threads, const std::function<void()>& afterStep)
  : Set(simplices)
  , Tree(AsTriangles(simplices), threads, afterStep)
{
}

//------------------------------------------------------------------------------
void Target::SetTolerances(std::vector<double> tolerances)
{
  this->Tolerances = std::move(tolerances);
  const auto largest = std::max_element(this->Tolerances.begin(), this->Tolerances.end());
  this->MaxTolerance = largest == this->Tolerances.end() ? 0.0 : *largest;
}

//------------------------------------------------------------------------------
std::shared_ptr<OverlayCover> Target::BorrowCover() const
{
  if (this->Set.Sides == nullptr || this->HasTolerances())
  {
    return nullptr;
  }
  return this->Covers.Borrow([this] { return std::make_unique<OverlayCover>(this->Set); });
}

//------------------------------------------------------------------------------
Corners Target::CornersOf(Index simplex) const
{
  const auto& [a, b, c] = this->Set.Corners[simplex];
  const Vector3& first = this->Set.Points[a];
  const Vector3& second = b == None ? first : this->Set.Points[b];
  return { first, second, c == None ? second : this->Set.Points[c] };
}

//------------------------------------------------------------------------------
Target::Candidate Target::FindLeast(const Vector3& p, Index hint) const
{
  const Index nearest = this->Tree.FindNearest(p, hint).Triangle;
  Candidate best = { nearest, this->ValueTo(p, nearest) };
  if (!this->HasTolerances())
  {
    return best;
  }
  // A simplex farther than this cannot have a smaller value, whatever its tolerance.
  double reach = Squared(best.Value + this->MaxTolerance);
  this->Tree.VisitNear(p, reach,
    [&](Index simplex)
    {
      const double value = this->ValueTo(p, simplex);
      if (value < best.Value || (value == best.Value && simplex < best.Simplex))
      {
        best = { simplex, value };
        reach = Squared(best.Value + this->MaxTolerance);
      }
    });
  return best;
}

//------------------------------------------------------------------------------
/// Walks from the hint to neighbors that are nearer, until one is near enough.
Target::Candidate Target::FindNear(const Vector3& p, Index hint, double sufficient) const
{
  const auto squaredTo = [&](Index simplex)
  {
    const Corners corners = this->CornersOf(simplex);
    return NearestOnTriangle(p, corners[0], corners[1], corners[2]).SquaredDistance;
  };
  double least = hint != None && sufficient >= 0.0 ? squaredTo(hint) : -1.0;
  for (Index from = None; least > sufficient * sufficient && from != hint;)
  {
    from = hint;
    for (const Index neighbor : this->Neighbors(from))
    {
      const double squared = neighbor >= 0 ? squaredTo(neighbor) : Infinity;
      hint = squared < least ? neighbor : hint;
      least = std::min(least, squared);
    }
  }
  const Candidate near = { hint, least >= 0.0 ? this->ValueTo(p, hint) : Infinity };
  return near.Value <= sufficient ? near : this->FindLeast(p, hint);
}

//------------------------------------------------------------------------------
double Target::ValueFromBelow(const Vector3& p, double startValue) const
{
  double least = startValue;
  for (std::size_t i = 0; i < this->Set.Size(); ++i)
  {
    const auto simplex = static_cast<Index>(i);
    const Corners corners = this->CornersOf(simplex);
    const double tolerance = this->Tolerance(simplex);
    if (DistanceToBox(p, corners) - tolerance < least)
    {
      least = std::min(least, DistanceFromBelow(p, corners, FindFoot(p, corners)) - tolerance);
    }
  }
  return least;
}

//------------------------------------------------------------------------------
Index Target::FindSame(const Corners& positions, int count) const
{
  Vector3 middle = positions[0];
  for (int i = 1; i < count; ++i)
  {
    middle += (positions[i] - positions[0]) / count;
  }
  Index same = None;
  this->Tree.VisitNear(middle, 0.0,
    [&](Index simplex)
    {
      const Corners corners = this->CornersOf(simplex);
      const auto isCorner = [&](const Vector3& position)
      { return std::find(corners.begin(), corners.end(), position) != corners.end(); };
      const bool hasAll = std::all_of(positions.begin(), positions.begin() + count, isCorner);
      same = hasAll && (same == None || simplex < same) ? simplex : same;
    });
  return same;
}
}
