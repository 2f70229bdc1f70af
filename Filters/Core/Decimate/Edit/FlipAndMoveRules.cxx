// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipAndMoveRules.h"

#include "Decimate/Kernels/FaceRules.h"
#include "Geometry/TriangleGeometry.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
struct Face
{
  Face(const Vector3& a, const Vector3& b, const Vector3& c)
    : Vector(AreaVector(a, b, c))
    , Area(this->Vector.norm())
  {
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    this->Quality = squares > 0.0 ? QualityOfEquilateral * this->Area / squares : 0.0;
  }

  Vector3 Vector; // mm^2
  double Area;    // mm^2
  double Quality = 0.0;
};

bool IsTurned(const Face& before, const Face& after)
{
  return before.Area > 0.0 &&
    Dot(before.Vector, after.Vector) < MinCosine * before.Area * after.Area;
}

/// @param quality Quality of the worst face before the edit.
bool IsNeedle(const Face& after, double quality)
{
  return !(after.Area > 0.0) || (after.Quality < MinQualityOfSmallEdit && after.Quality < quality);
}

Rejection RejectionOfConstrained(VertexConstraint kind)
{
  return kind == VertexConstraint::Constrained ? Rejection::Constrained : Rejection::NonManifold;
}

/// The rules of a flip that depend on positions.
/// @param isTurnedOver Whether a new face, 0 or 1, has turned over from its initial normal.
template <typename IsTurnedOver>
Rejection CheckShapesOfFlip(const std::array<Vector3, 4>& corners, const IsTurnedOver& isTurnedOver)
{
  const auto& [a, b, c, d] = corners;
  const std::array<Face, 2> before = { Face(a, b, c), Face(b, a, d) };
  const double worst = std::min(before[0].Quality, before[1].Quality);
  const std::array<Face, 2> afterwards = { Face(a, d, c), Face(b, c, d) };
  for (std::size_t i = 0; i < 2; ++i)
  {
    const Face& after = afterwards[i];
    if (IsNeedle(after, worst))
    {
      return Rejection::Degenerate;
    }
    if (IsTurned(before[0], after) || IsTurned(before[1], after) || isTurnedOver(i, after.Vector))
    {
      return Rejection::Flip;
    }
  }
  return Rejection::NotRejected;
}

Rejection CheckBoundarySplit(const HalfEdgeMesh& mesh, HalfEdgeId edge)
{
  const VertexId a = mesh.Origin(edge);
  const VertexId b = mesh.Target(edge);
  const bool isAlone =
    mesh.Twin(HalfEdgeMesh::Next(edge)) != None && mesh.Twin(HalfEdgeMesh::Previous(edge)) != None;
  const bool isOnCurve = mesh.IsStationary(a) && mesh.IsStationary(b);
  const bool isConstrained = mesh.IsConstrained(a) || mesh.IsConstrained(b);
  return isAlone && !isOnCurve && !isConstrained ? Rejection::NotRejected : Rejection::Boundary;
}
}

std::array<Index, 4> CornersAround(const HalfEdgeMesh& mesh, HalfEdgeId edge)
{
  const HalfEdgeId twin = mesh.Twin(edge);
  return { mesh.Origin(edge), mesh.Origin(twin), mesh.Apex(edge), mesh.Apex(twin) };
}

//------------------------------------------------------------------------------
std::array<Vector3, 4> PositionsOf(const HalfEdgeMesh& mesh, const std::array<Index, 4>& corners)
{
  return { mesh.Position(corners[0]), mesh.Position(corners[1]), mesh.Position(corners[2]),
    mesh.Position(corners[3]) };
}

//------------------------------------------------------------------------------
Rejection CheckFlipTopology(const HalfEdgeMesh& mesh, const std::array<Index, 4>& corners)
{
  for (const Index corner : corners)
  {
    if (mesh.IsConstrained(corner))
    {
      return RejectionOfConstrained(mesh.Constraint(corner));
    }
  }
  if (mesh.IsStationary(corners[0]) && mesh.IsStationary(corners[1]))
  {
    return Rejection::Boundary;
  }
  const bool swaps = IsHub(mesh, corners[2]);
  if (swaps && IsHub(mesh, corners[3]))
  {
    return Rejection::Valence;
  }
  const VertexId from = corners[swaps ? 3 : 2];
  const VertexId to = corners[swaps ? 2 : 3];
  bool joined = from == to;
  mesh.VisitEdges(from, [&](HalfEdgeId h) { joined = joined || mesh.OtherEnd(h, from) == to; });
  return joined ? Rejection::LinkCondition : Rejection::NotRejected;
}

//------------------------------------------------------------------------------
bool KeepsShape(const std::array<Vector3, 4>& corners)
{
  return CheckShapesOfFlip(corners, [](std::size_t, const Vector3&) { return false; }) ==
    Rejection::NotRejected;
}

//------------------------------------------------------------------------------
Rejection CheckFlip(const HalfEdgeMesh& mesh, SurfaceChange& change)
{
  const HalfEdgeId edge = change.Requested.Edge;
  if (mesh.Twin(edge) == None)
  {
    return Rejection::Boundary;
  }
  const std::array<Index, 4> corners = CornersAround(mesh, edge);
  const Rejection topology = CheckFlipTopology(mesh, corners);
  if (topology != Rejection::NotRejected)
  {
    return topology;
  }
  const std::array<Vector3, 4> positions = PositionsOf(mesh, corners);
  const std::array<Index, 2> faces = { HalfEdgeMesh::Face(edge),
    HalfEdgeMesh::Face(mesh.Twin(edge)) };
  const Rejection shape = CheckShapesOfFlip(positions,
    [&](std::size_t i, const Vector3& area) { return mesh.IsTurnedOver(faces[i], area); });
  if (shape == Rejection::NotRejected)
  {
    const auto& [a, b, c, d] = positions;
    change.VolumeChange = Dot(b - a, (c - a).cross(d - a)) / 6.0;
  }
  return shape;
}

//------------------------------------------------------------------------------
Rejection CheckMove(const HalfEdgeMesh& mesh, SurfaceChange& change)
{
  const VertexId vertex = change.Requested.Keep;
  const Vector3& position = change.Requested.Position;
  if (mesh.IsConstrained(vertex) || mesh.IsStationary(vertex))
  {
    return mesh.IsConstrained(vertex) ? RejectionOfConstrained(mesh.Constraint(vertex))
                                      : Rejection::Boundary;
  }
  if (IsHub(mesh, vertex))
  {
    return Rejection::Valence;
  }
  Vector3 ring = Vector3::Zero(); // mm^2
  for (const HalfEdgeId h : mesh.OutgoingOf(vertex))
  {
    const Vector3& second = mesh.Position(mesh.Target(h));
    const Vector3& third = mesh.Position(mesh.Apex(h));
    const Face before(mesh.Position(vertex), second, third);
    const Face after(position, second, third);
    if (IsNeedle(after, before.Quality))
    {
      return Rejection::Degenerate;
    }
    if (IsTurned(before, after) || mesh.IsTurnedOver(HalfEdgeMesh::Face(h), after.Vector))
    {
      return Rejection::Flip;
    }
    ring += before.Vector;
  }
  change.VolumeChange = Dot(ring, position - mesh.Position(vertex)) / 3.0;
  return Rejection::NotRejected;
}

//------------------------------------------------------------------------------
Rejection CheckSplit(const HalfEdgeMesh& mesh, HalfEdgeId edge)
{
  const VertexConstraint kind =
    std::min(mesh.Constraint(mesh.Origin(edge)), mesh.Constraint(mesh.Target(edge)));
  if (IsConstrained(kind))
  {
    return RejectionOfConstrained(kind);
  }
  return mesh.Twin(edge) == None ? CheckBoundarySplit(mesh, edge) : Rejection::NotRejected;
}

//------------------------------------------------------------------------------
Rejection CheckNewFace(const HalfEdgeMesh& mesh, FaceId old, const std::array<Vector3, 3>& corners)
{
  const auto [a, b, c] = PositionsOf(mesh, old);
  const Face before(a, b, c);
  const Face after(corners[0], corners[1], corners[2]);
  if (IsNeedle(after, before.Quality))
  {
    return Rejection::Degenerate;
  }
  return IsTurned(before, after) || mesh.IsTurnedOver(old, after.Vector) ? Rejection::Flip
                                                                         : Rejection::NotRejected;
}

//------------------------------------------------------------------------------
Rejection CheckNewFaces(const HalfEdgeMesh& mesh, SurfaceChange& change)
{
  const Vector3 origin = change.Requested.Position;
  const auto volume = [&origin](const Vector3& a, const Vector3& b, const Vector3& c)
  { return Dot(a - origin, (b - origin).cross(c - origin)) / 6.0; };
  double volumeChange = 0.0; // mm^3
  for (const Index old : change.OldFaces)
  {
    const auto [a, b, c] = PositionsOf(mesh, old);
    volumeChange -= volume(a, b, c);
  }
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    const Rejection rejection = CheckNewFace(mesh, face.Old(), face.Corners);
    if (rejection != Rejection::NotRejected)
    {
      return rejection;
    }
    const auto& [a, b, c] = face.Corners;
    volumeChange += volume(a, b, c);
  }
  change.VolumeChange = volumeChange;
  return Rejection::NotRejected;
}
}
