// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GrowingSurface.h"

#include "Mesh/SurfaceAssembly.h"

#include <array>
#include <map>
#include <utility>

namespace bonedecimate
{
namespace
{
using Coordinates = std::array<double, 3>;

Coordinates KeyOf(const Vector3& p)
{
  return { p[0], p[1], p[2] };
}

void Move(SurfacePiece& from, std::size_t triangle, SurfacePiece& to)
{
  to.Shape.Triangles.push_back(from.Shape.Triangles[triangle]);
  if (!from.Labels.empty())
  {
    to.Labels.push_back(from.Labels[triangle]);
  }
}

/// Moves the triangles for which isChosen(corners); all others keep their order.
template <typename IsChosen>
void MoveWhere(SurfacePiece& from, const IsChosen& isChosen, SurfacePiece& to)
{
  SurfacePiece stay;
  for (std::size_t t = 0; t < from.Shape.Triangles.size(); ++t)
  {
    Move(from, t, isChosen(from.Shape.Triangles[t]) ? to : stay);
  }
  from = std::move(stay);
}
}

void GrowingSurface::Add(const SurfacePiece& piece, const std::vector<Index>& points)
{
  for (const Triangle& c : piece.Shape.Triangles)
  {
    this->Open.Shape.Triangles.push_back({ points[c[0]], points[c[1]], points[c[2]] });
  }
  this->Open.Labels.insert(this->Open.Labels.end(), piece.Labels.begin(), piece.Labels.end());
}

//------------------------------------------------------------------------------
GrowingSurface::Strip GrowingSurface::Take(const Zone& zone)
{
  Strip strip;
  MoveWhere(
    this->Open, [&](const Triangle& c) { return Reaches(this->Points, c, zone); }, strip.Piece);
  strip.Points = NumberVertices(this->Points.size(), strip.Piece.Shape.Triangles, 1);
  for (const Index point : strip.Points)
  {
    strip.Piece.Shape.Points.push_back(this->Points[point]);
  }
  return strip;
}

//------------------------------------------------------------------------------
void GrowingSurface::PutBack(const Strip& taken, const SurfacePiece& changed)
{
  std::map<Coordinates, Index> known;
  for (const Index point : taken.Points)
  {
    known.emplace(KeyOf(this->Points[point]), point);
  }
  std::vector<Index> points;
  for (const Vector3& p : changed.Shape.Points)
  {
    const auto [at, isNew] = known.emplace(KeyOf(p), static_cast<Index>(this->Points.size()));
    if (isNew)
    {
      this->Points.push_back(p);
    }
    points.push_back(at->second);
  }
  this->Add(changed, points);
}

//------------------------------------------------------------------------------
void GrowingSurface::Finish(const Zone& above)
{
  MoveWhere(
    this->Open, [&](const Triangle& c) { return !Reaches(this->Points, c, above); },
    this->Finished);
}

//------------------------------------------------------------------------------
SurfacePiece GrowingSurface::Release()
{
  SurfacePiece all = std::move(this->Finished);
  MoveWhere(
    this->Open, [](const Triangle&) { return true; }, all);
  all.Shape.Points = std::move(this->Points);
  RemoveUnusedPoints(all.Shape);
  *this = {};
  return all;
}
}
