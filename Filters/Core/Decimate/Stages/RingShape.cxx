// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RingShape.h"

#include "Geometry/SmallestAngle.h"
#include "Geometry/TriangleGeometry.h"

namespace bonedecimate
{
namespace
{
constexpr double Diagonal = 0.7071067811865476; // of a square of side 1, half
constexpr std::array<std::array<double, 2>, 8> Directions = { { { 1, 0 }, { Diagonal, Diagonal },
  { 0, 1 }, { -Diagonal, Diagonal }, { -1, 0 }, { -Diagonal, -Diagonal }, { 0, -1 },
  { Diagonal, -Diagonal } } };
constexpr double FirstStep = 0.3; // of the mean distance to the ring
constexpr int StepLengths = 4;    // each half of the one before
constexpr int StepsOfLength = 4;
}

void RingShape::Gather(const HalfEdgeMesh& mesh, VertexId vertex)
{
  this->Sides.clear();
  for (const HalfEdgeId h : mesh.OutgoingOf(vertex))
  {
    this->Sides.push_back({ mesh.Position(mesh.Target(h)), mesh.Position(mesh.Apex(h)) });
  }
}

//------------------------------------------------------------------------------
void RingShape::Gather(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around)
{
  this->Sides.clear();
  for (std::size_t i = 0; i < around.Corners.size(); ++i)
  {
    this->Sides.push_back({ mesh.Position(around.Ring[i]), mesh.Position(around.RingAfter(i)) });
  }
}

//------------------------------------------------------------------------------
double RingShape::CosineAt(const Vector3& position, double enough) const
{
  double cosine = 0.0;
  for (const auto& [second, third] : this->Sides)
  {
    cosine = std::max(cosine, CosineOfSmallestAngle(position, second, third));
    if (cosine > enough)
    {
      break;
    }
  }
  return cosine;
}

//------------------------------------------------------------------------------
Vector3 RingShape::Search(const Vector3& from, double enough, double& cosine) const
{
  Vector3 normal = Vector3::Zero();
  double length = 0.0; // mm
  for (const auto& [second, third] : this->Sides)
  {
    normal += AreaVector(from, second, third);
    length += (second - from).norm() / static_cast<double>(this->Sides.size());
  }
  if (!(normal.squaredNorm() > 0.0))
  {
    return from;
  }
  const Vector3 u = normal.normalized().unitOrthogonal();
  const Vector3 v = normal.normalized().cross(u);
  Vector3 best = from;
  double step = FirstStep * length;
  for (int i = 0; i < StepLengths && cosine > enough; ++i, step *= 0.5)
  {
    bool isBetter = true;
    for (int k = 0; k < StepsOfLength && isBetter; ++k)
    {
      const Vector3 center = best;
      isBetter = false;
      for (const auto& [along, across] : Directions)
      {
        const Vector3 position = center + step * (along * u + across * v);
        const double there = this->CosineAt(position, cosine);
        if (there < cosine)
        {
          cosine = there;
          best = position;
          isBetter = true;
        }
      }
    }
  }
  return best;
}
}
