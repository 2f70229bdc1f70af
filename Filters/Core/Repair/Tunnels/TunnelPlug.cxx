// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TunnelPlug.h"

#include "Mesh/HalfEdgeMesh.h"
#include "Proof/Guard/TrianglePair.h"
#include "Repair/Caps/LeastAreaContour.h"

#include <algorithm>
#include <map>

namespace bonedecimate
{
namespace
{
bool IsIn(const std::vector<Index>& sorted, Index item)
{
  return std::binary_search(sorted.begin(), sorted.end(), item);
}

TriangleCorners PositionsOf(const PluggedSurface& surface, const Triangle& corners)
{
  return { surface.Point(corners[0]), surface.Point(corners[1]), surface.Point(corners[2]) };
}

/// Decided exactly; corners with the same id are common.
bool DoIntersect(const PluggedSurface& surface, const Triangle& a, const Triangle& b)
{
  return Meet(PlaneTriangle(PositionsOf(surface, a)), a, PlaneTriangle(PositionsOf(surface, b)), b);
}

/// Six times the volume of the tetrahedron with a point, mm^3.
double SixVolumes(const PluggedSurface& surface, const Triangle& corners, const Vector3& from)
{
  return Dot(surface.Point(corners[0]) - from,
    (surface.Point(corners[1]) - from).cross(surface.Point(corners[2]) - from));
}
}

//------------------------------------------------------------------------------
TunnelObstacle PlugMaker::Make(const std::vector<Index>& loop, TunnelPlug& plug) const
{
  TunnelObstacle obstacle = TunnelObstacle::NoObstacle;
  for (const Side side : { Side::Both, Side::Left, Side::Right })
  {
    plug = {};
    const TunnelObstacle found = this->MakeOn(side, loop, plug);
    if (found == TunnelObstacle::NoObstacle)
    {
      return found;
    }
    obstacle = std::max(obstacle, found);
  }
  return obstacle;
}

//------------------------------------------------------------------------------
TunnelObstacle PlugMaker::MakeOn(Side side, const std::vector<Index>& loop, TunnelPlug& plug) const
{
  plug.Band = this->BandAlong(loop, side);
  if (plug.Band.empty())
  {
    return TunnelObstacle::NoAnnulus;
  }
  if (!this->IsFree(plug.Band))
  {
    return TunnelObstacle::Constrained;
  }
  const std::vector<std::vector<Index>> rims = this->RimsOf(plug.Band);
  if (rims.size() != 2)
  {
    return TunnelObstacle::NoAnnulus;
  }
  if (!this->AddCap(rims[0], plug) || !this->AddCap(rims[1], plug) || this->Intersects(plug))
  {
    return TunnelObstacle::Intersection;
  }
  plug.Volume = this->VolumeOf(plug);
  return plug.Volume > 0.0 ? TunnelObstacle::NoObstacle : TunnelObstacle::AmbiguousLoop;
}

//------------------------------------------------------------------------------
/// Adds the triangles around a point of the loop, on one side or both.
/// @return False at a boundary.
bool PlugMaker::AddRing(
  Side side, Index before, Index point, Index after, std::vector<Index>& band) const
{
  std::vector<Index> ring; // half-edges from the point, counter-clockwise
  std::size_t start = 0;
  std::size_t end = 0;
  const Index first = this->Graph.Outgoing(point);
  for (Index h = first; ring.empty() || h != first;)
  {
    const Triangle& corners = this->Remaining.Triangles[static_cast<std::size_t>(h >> 2)];
    const Index to = corners[static_cast<std::size_t>(HalfEdgeMesh::Next(h) & 3)];
    start = to == (side == Side::Right ? before : after) ? ring.size() : start;
    end = to == (side == Side::Right ? after : before) ? ring.size() : end;
    ring.push_back(h);
    h = this->Graph.Twin(HalfEdgeMesh::Previous(h));
    if (h < 0)
    {
      return false;
    }
  }
  const std::size_t count =
    side == Side::Both ? ring.size() : (end + ring.size() - start) % ring.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    band.push_back(ring[(start + i) % ring.size()] >> 2);
  }
  return true;
}

//------------------------------------------------------------------------------
/// The triangles along the loop, ascending; empty if the loop meets a boundary.
std::vector<Index> PlugMaker::BandAlong(const std::vector<Index>& loop, Side side) const
{
  std::vector<Index> band;
  const std::size_t count = loop.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!this->AddRing(side, loop[(i + count - 1) % count], loop[i], loop[(i + 1) % count], band))
    {
      return {};
    }
  }
  std::sort(band.begin(), band.end());
  band.erase(std::unique(band.begin(), band.end()), band.end());
  return band;
}

//------------------------------------------------------------------------------
/// Whether all of it may be removed.
bool PlugMaker::IsFree(const std::vector<Index>& band) const
{
  const std::vector<Index>& labels = this->Constraints.Labels;
  const auto labelOf = [&](Index face)
  {
    auto id = static_cast<std::size_t>(this->Ids[static_cast<std::size_t>(face)]);
    const std::size_t first = this->Plugged.InitialTriangles;
    id = id < first ? id : static_cast<std::size_t>(this->Plugged.Replaced[id - first]);
    return labels.empty() ? 0 : labels[id];
  };
  return std::all_of(band.begin(), band.end(),
    [&](Index face)
    {
      const Triangle& corners = this->Remaining.Triangles[static_cast<std::size_t>(face)];
      return labelOf(face) == labelOf(band.front()) &&
        std::none_of(corners.begin(), corners.end(),
          [&](Index c) { return this->Constraints.IsFixed[static_cast<std::size_t>(c)] != 0; });
    });
}

//------------------------------------------------------------------------------
/// The boundaries of an annulus, in the direction of its triangles; none if it is not one.
std::vector<std::vector<Index>> PlugMaker::RimsOf(const std::vector<Index>& band) const
{
  std::map<Index, Index> next;
  std::vector<Index> points;
  for (const Index face : band)
  {
    const Triangle& corners = this->Remaining.Triangles[static_cast<std::size_t>(face)];
    points.insert(points.end(), corners.begin(), corners.end());
    for (Index k = 0; k < 3; ++k)
    {
      const Index twin = this->Graph.Twin(4 * face + k);
      const bool isRim = twin < 0 || !IsIn(band, twin >> 2);
      if (twin < 0 ||
        (isRim &&
          !next
             .emplace(
               corners[static_cast<std::size_t>(k)], corners[static_cast<std::size_t>((k + 1) % 3)])
             .second))
      {
        return {};
      }
    }
  }
  std::sort(points.begin(), points.end());
  const auto used = std::unique(points.begin(), points.end()) - points.begin();
  const auto faces = static_cast<std::ptrdiff_t>(band.size());
  if (2 * (used + faces) != 3 * faces + static_cast<std::ptrdiff_t>(next.size()))
  {
    return {};
  }
  std::vector<std::vector<Index>> rims;
  while (!next.empty())
  {
    rims.emplace_back();
    for (auto at = next.begin(); at != next.end();)
    {
      const Index to = at->second;
      rims.back().push_back(at->first);
      next.erase(at);
      at = next.find(to);
    }
  }
  return rims;
}

//------------------------------------------------------------------------------
/// Whether the surface has the edge outside of the band, or on its rim.
bool PlugMaker::HasOtherEdge(Index a, Index b, const std::vector<Index>& band) const
{
  return std::any_of(this->Graph.Begin(a), this->Graph.End(a),
    [&](const GraphSpoke& spoke)
    {
      const std::array<Index, 2>& sides =
        this->Graph.Edges()[static_cast<std::size_t>(spoke.Edge)].Sides;
      return spoke.To == b && !(IsIn(band, sides[0]) && IsIn(band, sides[1]));
    });
}

//------------------------------------------------------------------------------
bool PlugMaker::AddCap(const std::vector<Index>& rim, TunnelPlug& plug) const
{
  std::vector<Vector3> contour;
  contour.reserve(rim.size());
  for (const Index point : rim)
  {
    contour.push_back(this->Plugged.Point(point));
  }
  const auto idOf = [&rim](Index i) { return rim[static_cast<std::size_t>(i)]; };
  const std::vector<Triangle> triangles = FillByLeastArea(
    contour, [&](Index a, Index b) { return !this->HasOtherEdge(idOf(a), idOf(b), plug.Band); });
  for (const Triangle& corners : triangles)
  {
    plug.Caps.push_back({ idOf(corners[0]), idOf(corners[1]), idOf(corners[2]) });
  }
  return !triangles.empty();
}

//------------------------------------------------------------------------------
/// mm^3, by which the enclosed volume grows.
double PlugMaker::VolumeOf(const TunnelPlug& plug) const
{
  const Vector3& from = this->Plugged.Point(plug.Caps.front()[0]);
  double six = 0.0;
  for (const Triangle& corners : plug.Caps)
  {
    six += SixVolumes(this->Plugged, corners, from);
  }
  for (const Index face : plug.Band)
  {
    six -=
      SixVolumes(this->Plugged, this->Remaining.Triangles[static_cast<std::size_t>(face)], from);
  }
  return six / 6.0;
}

//------------------------------------------------------------------------------
/// Whether a cap has a triangle without area, or intersects the other cap, itself or what remains
/// of the surface.
bool PlugMaker::Intersects(const TunnelPlug& plug) const
{
  const PluggedSurface& surface = this->Plugged;
  std::vector<Index> removed;
  removed.reserve(plug.Band.size());
  for (const Index face : plug.Band)
  {
    removed.push_back(this->Ids[static_cast<std::size_t>(face)]); // ascending, as the faces are
  }
  for (std::size_t i = 0; i < plug.Caps.size(); ++i)
  {
    const Triangle& cap = plug.Caps[i];
    const TriangleCorners corners = PositionsOf(surface, cap);
    bool isBad = !HasArea(corners) ||
      std::any_of(plug.Caps.begin() + static_cast<std::ptrdiff_t>(i) + 1, plug.Caps.end(),
        [&](const Triangle& other) { return DoIntersect(surface, cap, other); });
    const auto meets = [&](Index id)
    {
      const auto t = static_cast<std::size_t>(id);
      isBad = isBad ||
        (surface.IsRemoved[t] == 0 && !IsIn(removed, id) &&
          DoIntersect(surface, cap, surface.Whole.Triangles[t]));
    };
    const Vector3 center = (corners[0] + corners[1] + corners[2]) / 3.0;
    double squared = 0.0; // mm^2, to the corners; a little more because of rounding
    for (const Vector3& corner : corners)
    {
      squared = std::max(squared, 1.001 * (corner - center).squaredNorm());
    }
    if (!isBad)
    {
      surface.Tree.VisitNear(center, squared, meets);
    }
    for (std::size_t t = surface.InitialTriangles; !isBad && t < surface.Whole.Triangles.size();
         ++t)
    {
      meets(static_cast<Index>(t));
    }
    if (isBad)
    {
      return true;
    }
  }
  return false;
}
}
