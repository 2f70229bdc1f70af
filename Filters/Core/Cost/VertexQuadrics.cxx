// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexQuadrics.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double Ridge = 1e-4; // of the mean eigenvalue of M
constexpr double MemoryWeight = 0.03;
constexpr double FarthestMove = 2.0; // edge lengths from the middle
}

VertexQuadrics::VertexQuadrics(const HalfEdgeMesh& mesh, const FaceAreas& areas, double unit)
  : Mesh(mesh)
  , Areas(areas)
  , Unit(unit)
  , Records(static_cast<std::size_t>(mesh.NumberOfVertexSlots()))
  , Memories(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), 0.0)
{
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    for (const Index corner : mesh.Corners(face))
    {
      AddPlane(this->Records[corner], areas[face]);
    }
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
    {
      if (mesh.Twin(h) == None)
      {
        const Vector3 edge = mesh.Position(mesh.Target(h)) - mesh.Position(mesh.Origin(h));
        AddBorderEdge(this->Records[mesh.Origin(h)], edge);
        AddBorderEdge(this->Records[mesh.Target(h)], edge);
      }
    }
  }
}

//------------------------------------------------------------------------------
void VertexQuadrics::Update(Index v)
{
  Record record;
  this->Mesh.VisitEdges(v,
    [&](Index h)
    {
      if (this->Mesh.Origin(h) == v)
      {
        AddPlane(record, this->Areas[HalfEdgeMesh::Face(h)]);
      }
      if (this->Mesh.Twin(h) == None)
      {
        AddBorderEdge(record,
          this->Mesh.Position(this->Mesh.Target(h)) - this->Mesh.Position(this->Mesh.Origin(h)));
      }
    });
  this->Records[v] = record;
}

//------------------------------------------------------------------------------
VertexQuadrics::Answer VertexQuadrics::Evaluate(Index v, Index w, Freedom freedom) const
{
  const Record& first = this->Records[v];
  const Record& second = this->Records[w];
  const Vector3 half = 0.5 * (this->Mesh.Position(w) - this->Mesh.Position(v));
  Record sum;
  Symmetric difference;
  for (std::size_t i = 0; i < 6; ++i)
  {
    sum.M[i] = first.M[i] + second.M[i];
    difference[i] = second.M[i] - first.M[i];
  }
  sum.G = first.G + second.G;
  const Vector3 r = Times(difference, half);
  Vector3 x = freedom == Freedom::First ? Vector3(-half) : half;
  if (freedom == Freedom::Space)
  {
    x = PlaceInSpace(sum, r, (second.G - first.G).dot(half), half);
  }
  else if (freedom == Freedom::Edge)
  {
    x = PlaceOnEdge(sum, r, half);
  }
  const double q =
    std::max(0.0, x.dot(Times(sum.M, x)) - 2.0 * r.dot(x) + half.dot(Times(sum.M, half)));
  const double left = std::max(this->Memories[v], this->Memories[w]);
  return { this->CostOf(sum.M[0] + sum.M[3] + sum.M[5], q, left),
    this->Mesh.Position(v) + half + x };
}

//------------------------------------------------------------------------------
/// Of S (mm^2), Q (mm^4) and D (mm).
double VertexQuadrics::CostOf(double s, double q, double left) const
{
  const double perArea = 1.0 / (this->Unit * this->Unit);
  const double freeS = s * perArea;
  const double freeQ = q * perArea * perArea;
  const double freeLeft = left / this->Unit;
  return std::sqrt(std::sqrt(freeS) * freeQ * std::sqrt(freeQ)) +
    MemoryWeight * 0.5 * freeS * freeLeft * std::sqrt(freeLeft);
}

//------------------------------------------------------------------------------
Vector3 VertexQuadrics::PlaceInSpace(
  const Record& sum, const Vector3& r, double d, const Vector3& half)
{
  Symmetric ridged = sum.M;
  const double ridge = Ridge * (sum.M[0] + sum.M[3] + sum.M[5]) / 3.0;
  for (const std::size_t diagonal : { 0, 3, 5 })
  {
    ridged[diagonal] += ridge;
  }
  Symmetric inverse;
  if (!Invert(ridged, inverse))
  {
    return Vector3::Zero();
  }
  const double farthest = 4.0 * FarthestMove * FarthestMove * half.squaredNorm();
  const Vector3 free = Times(inverse, r);
  const Vector3 y = Times(inverse, sum.G);
  const double gy = sum.G.dot(y);
  if (gy > 0.0)
  {
    const Vector3 kept = free + y * ((d - sum.G.dot(free)) / gy);
    if (kept.squaredNorm() <= farthest)
    {
      return kept;
    }
  }
  return free.squaredNorm() <= farthest ? free : Vector3(Vector3::Zero());
}

//------------------------------------------------------------------------------
/// The minimum of Q over x = t half, t from -1 to 1.
Vector3 VertexQuadrics::PlaceOnEdge(const Record& sum, const Vector3& r, const Vector3& half)
{
  const double curvature = half.dot(Times(sum.M, half));
  return curvature > 0.0 ? Vector3(std::clamp(r.dot(half) / curvature, -1.0, 1.0) * half)
                         : Vector3(Vector3::Zero());
}

//------------------------------------------------------------------------------
Vector3 VertexQuadrics::Times(const Symmetric& m, const Vector3& x)
{
  return { m[0] * x[0] + m[1] * x[1] + m[2] * x[2], m[1] * x[0] + m[3] * x[1] + m[4] * x[2],
    m[2] * x[0] + m[4] * x[1] + m[5] * x[2] };
}

//------------------------------------------------------------------------------
bool VertexQuadrics::Invert(const Symmetric& m, Symmetric& inverse)
{
  const double xx = m[3] * m[5] - m[4] * m[4];
  const double xy = m[2] * m[4] - m[1] * m[5];
  const double xz = m[1] * m[4] - m[2] * m[3];
  const double determinant = m[0] * xx + m[1] * xy + m[2] * xz;
  if (!(determinant > 0.0))
  {
    return false;
  }
  inverse = { xx, xy, xz, m[0] * m[5] - m[2] * m[2], m[1] * m[2] - m[0] * m[4],
    m[0] * m[3] - m[1] * m[1] };
  for (double& entry : inverse)
  {
    entry /= determinant;
  }
  return true;
}

//------------------------------------------------------------------------------
void VertexQuadrics::AddPlane(Record& record, const FaceAreas::Face& face)
{
  const Vector3 scaled = 2.0 * face.Area * face.Normal;
  const Vector3& n = face.Normal;
  record.M[0] += scaled[0] * n[0];
  record.M[1] += scaled[0] * n[1];
  record.M[2] += scaled[0] * n[2];
  record.M[3] += scaled[1] * n[1];
  record.M[4] += scaled[1] * n[2];
  record.M[5] += scaled[2] * n[2];
  record.G += scaled;
}

//------------------------------------------------------------------------------
void VertexQuadrics::AddBorderEdge(Record& record, const Vector3& edge)
{
  const double squared = edge.squaredNorm();
  record.M[0] += 2.0 * (squared - edge[0] * edge[0]);
  record.M[1] -= 2.0 * edge[0] * edge[1];
  record.M[2] -= 2.0 * edge[0] * edge[2];
  record.M[3] += 2.0 * (squared - edge[1] * edge[1]);
  record.M[4] -= 2.0 * edge[1] * edge[2];
  record.M[5] += 2.0 * (squared - edge[2] * edge[2]);
}
}
