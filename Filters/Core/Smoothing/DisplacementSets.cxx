// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DisplacementSets.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr double Slack = 4e-3; // half voxels
/// Part of it for rounding; the rest keeps triangles 10^-3 voxels away from voxel centers.
constexpr double SlackOfRounding = 0.125 * Slack;

int NumberOfOdd(const GridPoint& point)
{
  return static_cast<int>(
    std::count_if(point.begin(), point.end(), [](std::int32_t i) { return i % 2 != 0; }));
}

/// The point of the octahedron sum w |x| <= radius that is nearest to p: p shortened by t w along
/// each axis, with a threshold t.
Vector3 NearestInOctahedron(const Vector3& p, const Vector3& w, double radius)
{
  const Vector3 lengths = p.cwiseAbs();
  if (Dot(w, lengths) <= radius)
  {
    return p;
  }
  std::array<bool, 3> isActive = { true, true, true };
  double threshold = 0.0;
  // An axis whose length falls below 0 is 0 in the nearest point. The threshold only grows without
  // it.
  for (bool isDone = false; !isDone;)
  {
    double sum = -radius;
    double squares = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      sum += isActive[k] ? w[k] * lengths[k] : 0.0;
      squares += isActive[k] ? w[k] * w[k] : 0.0;
    }
    threshold = sum / squares;
    isDone = true;
    for (int k = 0; k < 3; ++k)
    {
      if (isActive[k] && lengths[k] < threshold * w[k])
      {
        isActive[k] = false;
        isDone = false;
      }
    }
  }
  Vector3 nearest;
  for (int k = 0; k < 3; ++k)
  {
    nearest[k] =
      isActive[k] ? std::copysign(std::max(0.0, lengths[k] - threshold * w[k]), p[k]) : 0.0;
  }
  return nearest;
}
}

DisplacementSets::DisplacementSets(const std::vector<Vector3>& points, std::vector<double> radii,
  const LabelMapSource* source, bool inVoxels, int threads)
  : InVoxels(inVoxels)
  , Radii(std::move(radii))
{
  if (source != nullptr && !source->OfPoint.empty())
  {
    this->Axes = source->Grid.Direction;
    this->IsSheared = !source->Grid.IsOrthogonal();
    this->InverseAxes = source->Grid.InverseDirection();
    this->Unit = inVoxels ? Vector3(0.5 * source->Grid.Spacing) : Vector3(Vector3::Ones());
    this->HalfVoxelsPerUnit = this->Unit.cwiseQuotient(0.5 * source->Grid.Spacing);
    this->AddOctahedra(points, *source, threads);
  }
}

//------------------------------------------------------------------------------
/// A point outside of its octahedron was not extracted there; it does not move.
void DisplacementSets::AddOctahedra(
  const std::vector<Vector3>& points, const LabelMapSource& source, int threads)
{
  this->Octahedra.resize(points.size());
  this->HalfVoxelsAlongThird.resize(source.Grid.HasLayers() ? points.size() : 0);
  ForEachId(points.size(), threads,
    [&](std::size_t p)
    {
      const GridPoint& center = source.OfPoint[p];
      const Vector3 halves(center[0], center[1], center[2]);
      Vector3 halfVoxels;
      if (source.Grid.HasLayers())
      {
        const Vector3 half = HalfSidesAt(source.Grid, center);
        this->HalfVoxelsAlongThird[p] = this->Unit[2] / half[2];
        halfVoxels =
          this->InMillimetersAlongAxes(points[p] - source.Grid.ToMillimeters(0.5 * halves))
            .cwiseQuotient(half);
      }
      else
      {
        halfVoxels = 2.0 * source.Grid.ToVoxels(points[p]) - halves;
      }
      this->Octahedra[p] = { halfVoxels.cwiseQuotient(this->HalfVoxelsPerUnitAt(p)),
        NumberOfOdd(center) - Slack };
      if (!(halfVoxels.cwiseAbs().sum() <= this->Octahedra[p].Radius))
      {
        this->Radii[p] = 0.0;
      }
    });
}

//------------------------------------------------------------------------------
Vector3 DisplacementSets::OntoFace(Index point, const Vector3& from) const
{
  const Octahedron& octahedron = this->Octahedra[point];
  return NearestInOctahedron(from, this->HalfVoxelsPerUnitAt(point), octahedron.Radius) -
    octahedron.FromCenter;
}

//------------------------------------------------------------------------------
bool DisplacementSets::KeepsToOctahedron(Index point, const Vector3& millimeters) const
{
  if (this->Octahedra.empty())
  {
    return true;
  }
  const Octahedron& octahedron = this->Octahedra[point];
  const Vector3 from = octahedron.FromCenter + this->FromMillimeters(millimeters);
  return Dot(this->HalfVoxelsPerUnitAt(point), from.cwiseAbs()) <=
    octahedron.Radius + SlackOfRounding;
}
}
