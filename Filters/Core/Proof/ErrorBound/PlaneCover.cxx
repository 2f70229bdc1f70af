// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneCover.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Least squared sine of the angle at A. With a sharper one, projections are too inaccurate.
constexpr double MinSquaredSineOfFace = 1e-8;
/// Bound of the rounding of a sum of four products.
constexpr double Rounding = 1e-14;

struct Barycentric
{
  double B, C;
};

/// Where the projections are counted: an arbitrary point that edges are unlikely to pass through.
constexpr Barycentric CountedPoint = { 0.3279, 0.3391 };

/// Twice the area of p q r, and how wrong it may be.
struct Turn
{
  Turn(Barycentric p, Barycentric q, Barycentric r)
    : Value((q.B - p.B) * (r.C - p.C) - (q.C - p.C) * (r.B - p.B))
    , Error(Rounding *
        ((std::abs(q.B) + std::abs(p.B)) * (std::abs(r.C) + std::abs(p.C)) +
          (std::abs(q.C) + std::abs(p.C)) * (std::abs(r.B) + std::abs(p.B))))
  {
  }
  int Sign() const { return this->Value > this->Error ? 1 : this->Value < -this->Error ? -1 : 0; }

  double Value, Error;
};

/// The sides of the triangle (0, 0), (1, 0), (0, 1) that the point certainly lies beyond.
std::uint8_t SidesBeyond(Barycentric p)
{
  const double a = 1.0 - p.B - p.C;
  const double error = Rounding * (1.0 + std::abs(p.B) + std::abs(p.C));
  return static_cast<std::uint8_t>(
    (p.B < 0.0 ? 1 : 0) | (p.C < 0.0 ? 2 : 0) | (a < -error ? 4 : 0));
}

/// Bits for the four directions in which the point lies.
std::uint8_t SidesOf(Barycentric middle, Barycentric p)
{
  return static_cast<std::uint8_t>((p.B < middle.B ? 1 : 0) | (p.B > middle.B ? 2 : 0) |
    (p.C < middle.C ? 4 : 0) | (p.C > middle.C ? 8 : 0));
}

/// Whether the line through both points may meet the triangle (0, 0), (1, 0), (0, 1). False only if
/// it certainly does not.
bool PassesFace(Barycentric p, Barycentric q)
{
  const int first = Turn(p, q, { 0.0, 0.0 }).Sign();
  return first == 0 || Turn(p, q, { 1.0, 0.0 }).Sign() != first ||
    Turn(p, q, { 0.0, 1.0 }).Sign() != first;
}
}

//------------------------------------------------------------------------------
bool PlaneCover::Begin(const std::array<Vector3, 3>& face)
{
  this->Triangles.Clear();
  this->Projections.Clear();
  this->IsOdd = false;
  this->SuspectB = CountedPoint.B;
  this->SuspectC = CountedPoint.C;
  this->A = face[0];
  this->AB = face[1] - face[0];
  this->AC = face[2] - face[0];
  const double bb = this->AB.squaredNorm();
  const double bc = Dot(this->AB, this->AC);
  const double cc = this->AC.squaredNorm();
  const double determinant = bb * cc - bc * bc;
  if (!(determinant > MinSquaredSineOfFace * bb * cc))
  {
    return false;
  }
  this->AlongB = (cc * this->AB - bc * this->AC) / determinant;
  this->AlongC = (bb * this->AC - bc * this->AB) / determinant;
  return true;
}

//------------------------------------------------------------------------------
const PlaneCover::Projection& PlaneCover::ProjectionOf(VertexId vertex)
{
  Index at = this->Projections.Find(vertex);
  if (at == None)
  {
    const Vector3 p = this->OriginalMesh.Position(vertex) - this->A;
    const Barycentric barycentric = { Dot(this->AlongB, p), Dot(this->AlongC, p) };
    Projection projection = { vertex, SidesBeyond(barycentric), SidesOf(CountedPoint, barycentric),
      barycentric.B, barycentric.C, {}, 0.0 };
    projection.Offset = p - projection.B * this->AB - projection.C * this->AC;
    projection.SquaredOffset = projection.Offset.squaredNorm();
    at = this->Projections.Insert(projection);
  }
  return this->Projections[at];
}

//------------------------------------------------------------------------------
bool PlaneCover::Visit(Index triangle, double limit)
{
  const Triangle corners = this->OriginalMesh.Corners(triangle);
  ProjectedTriangle projected;
  std::transform(corners.begin(), corners.end(), projected.begin(),
    [this](VertexId v) { return this->ProjectionOf(v); });
  if ((projected[0].Beyond & projected[1].Beyond & projected[2].Beyond) != 0)
  {
    return true; // nowhere over the face
  }
  const double farthest = std::max(
    { projected[0].SquaredOffset, projected[1].SquaredOffset, projected[2].SquaredOffset });
  if ((farthest > limit * limit && !this->IsNearOver(projected, limit)) || !this->Count(projected))
  {
    return false;
  }
  for (Index k = 0; k < 3; ++k)
  {
    const Projection& p = projected[k];
    const Projection& q = projected[(k + 1) % 3];
    const bool meets = (p.Beyond & q.Beyond) == 0 &&
      (p.Beyond == 0 || q.Beyond == 0 || PassesFace({ p.B, p.C }, { q.B, q.C }));
    if (meets && !this->Cross(HalfEdgeMesh::HalfEdge(triangle, k)))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Counts the projection if it contains the counted point. False if rounding leaves that open.
bool PlaneCover::Count(const ProjectedTriangle& projected)
{
  if ((projected[0].Beside & projected[1].Beside & projected[2].Beside) != 0)
  {
    return true;
  }
  int turns = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Projection& p = projected[k];
    const Projection& q = projected[(k + 1) % 3];
    const int turn = Turn({ p.B, p.C }, { q.B, q.C }, CountedPoint).Sign();
    if (turn == 0)
    {
      return false;
    }
    turns += turn;
  }
  this->IsOdd = this->IsOdd != (std::abs(turns) == 3);
  return true;
}

//------------------------------------------------------------------------------
/// Adds the triangle across an edge; false if there is none.
bool PlaneCover::Cross(Index edge)
{
  const HalfEdgeId twin = this->OriginalMesh.Twin(edge);
  if (twin != None && this->Triangles.Find(HalfEdgeMesh::Face(twin)) == None)
  {
    this->Triangles.Insert({ HalfEdgeMesh::Face(twin) });
  }
  return twin != None;
}

//------------------------------------------------------------------------------
/// Clips the projection at the face. The offset is greatest at a corner of what remains.
bool PlaneCover::IsNearOver(const ProjectedTriangle& projected, double limit)
{
  std::array<std::array<Projection, 9>, 2> polygons;
  std::copy(projected.begin(), projected.end(), polygons[0].begin());
  std::size_t count = 3;
  for (int side = 0; side < 3; ++side)
  {
    const auto inside = [side](const Projection& s) {
      return side == 0 ? s.B : side == 1 ? s.C : s.A();
    };
    const auto& from = polygons[side % 2];
    auto& to = polygons[(side + 1) % 2];
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Projection& p = from[i];
      const Projection& q = from[(i + 1) % count];
      const double pIn = inside(p);
      const double qIn = inside(q);
      if (pIn >= 0.0)
      {
        to[kept++] = p;
      }
      if ((pIn >= 0.0) != (qIn >= 0.0))
      {
        const double t = pIn / (pIn - qIn);
        to[kept++] = { None, 0, 0, p.B + t * (q.B - p.B), p.C + t * (q.C - p.C),
          p.Offset + t * (q.Offset - p.Offset), 0.0 };
      }
    }
    count = kept;
  }
  const auto end = polygons[1].begin() + static_cast<std::ptrdiff_t>(count);
  const auto far = std::find_if(polygons[1].begin(), end,
    [limit](const Projection& s) { return !(s.Offset.squaredNorm() <= limit * limit); });
  if (far != end)
  {
    this->SuspectB = far->B;
    this->SuspectC = far->C;
  }
  return far == end;
}
}
