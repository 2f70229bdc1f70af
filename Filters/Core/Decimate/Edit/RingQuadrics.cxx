// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RingQuadrics.h"

#include "Base/Parallel.h"
#include "EditWorkspace.h"

namespace bonedecimate
{
namespace
{
/// A sum of quadrics in double precision.
class Sum
{
public:
  explicit Sum(double perUnit)
    : PerArea(perUnit * perUnit)
  {
  }

  /// @param n Twice the area vector, mm^2.
  void AddPlane(const Vector3& n)
  {
    const double length = n.norm();
    const Vector3 scaled = length > 0.0 ? Vector3(n / length) : Vector3(Vector3::Zero());
    this->AddProduct(scaled, n);
    this->G += n;
  }

  /// @param b A boundary edge, mm.
  void AddBoundaryEdge(const Vector3& b)
  {
    const double squared = 2.0 * b.squaredNorm();
    this->AddProduct(-2.0 * b, b);
    this->M[0] += squared;
    this->M[3] += squared;
    this->M[5] += squared;
  }

  /// Adds `sign` times this sum to a quadric.
  void AddTo(RingQuadric& quadric, double sign) const
  {
    const double factor = sign * this->PerArea;
    for (std::size_t i = 0; i < 6; ++i)
    {
      quadric.M[i] += static_cast<float>(factor * this->M[i]);
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      quadric.G[i] += static_cast<float>(factor * this->G[static_cast<Eigen::Index>(i)]);
    }
  }

private:
  void AddProduct(const Vector3& a, const Vector3& b)
  {
    this->M[0] += a[0] * b[0];
    this->M[1] += a[0] * b[1];
    this->M[2] += a[0] * b[2];
    this->M[3] += a[1] * b[1];
    this->M[4] += a[1] * b[2];
    this->M[5] += a[2] * b[2];
  }

  double PerArea;              // 1/mm^2
  std::array<double, 6> M{};   // mm^2
  Vector3 G = Vector3::Zero(); // mm^2
};

/// Sums the planes around one vertex after the other.
class RingSum
{
public:
  explicit RingSum(const HalfEdgeMesh& mesh)
    : Mesh(mesh)
  {
  }

  RingQuadric At(VertexId v)
  {
    this->Ring.clear();
    this->Mesh.VisitNeighbors(v, [&](Index, Index other) { this->Ring.push_back(other); });
    const bool isOpen = this->Mesh.IsOnBoundary(v);
    if (!isOpen)
    {
      this->Ring.push_back(this->Ring.front());
    }
    const double perUnit = 1.0 / this->Mesh.Unit();
    RingQuadric quadric = this->KernelSet.SumPlanes(this->Fill(v), perUnit * perUnit);
    if (isOpen)
    {
      Sum boundary(perUnit);
      boundary.AddBoundaryEdge(this->Mesh.Position(this->Ring.front()) - this->Mesh.Position(v));
      boundary.AddBoundaryEdge(this->Mesh.Position(this->Ring.back()) - this->Mesh.Position(v));
      boundary.AddTo(quadric, 1.0);
    }
    return quadric;
  }

private:
  const Fan& Fill(VertexId v)
  {
    const Vector3 middle = this->Mesh.Position(v);
    const Fan& fan = this->Storage.Reserve(static_cast<int>(this->Ring.size()) - 1);
    double* const to[3] = { fan.Ring[0], fan.Ring[1], fan.Ring[2] };
    for (std::size_t i = 0; i < this->Ring.size(); ++i)
    {
      const Vector3& end = this->Mesh.Position(this->Ring[i]);
      to[0][i] = end[0] - middle[0];
      to[1][i] = end[1] - middle[1];
      to[2][i] = end[2] - middle[2];
    }
    return fan;
  }

  const HalfEdgeMesh& Mesh;
  const Kernels& KernelSet = BestKernels();
  std::vector<Index> Ring; // closed rings repeat the first vertex at the end
  FanStorage Storage;
};

void TakeGonePlanes(
  HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Vector3& origin, const Vector3& end)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(around.NumberOfRemovedFaces); ++i)
  {
    const Vector3 apex = mesh.Position(around.Apexes[i]) - origin;
    Sum gone(1.0 / mesh.Unit());
    gone.AddPlane(i == 0 ? Vector3(end.cross(apex)) : Vector3(apex.cross(end)));
    gone.AddTo(mesh.Quadric(around.Apexes[i]), -1.0);
  }
}

void ExchangeBoundaryEdges(HalfEdgeMesh& mesh, const EdgeNeighborhood& around, VertexId keep,
  const Vector3& origin, const Vector3& end)
{
  const std::array<Index, 2> others = { around.Ring.front(), around.Ring.back() };
  for (std::size_t i = 0; i < 2; ++i)
  {
    const Vector3 other = mesh.Position(others[i]) - origin;
    Sum before(1.0 / mesh.Unit());
    before.AddBoundaryEdge(around.BoundaryEnds[i] == around.End ? Vector3(other - end) : other);
    before.AddTo(mesh.Quadric(others[i]), -1.0);
    Sum after(1.0 / mesh.Unit());
    after.AddBoundaryEdge(mesh.Position(others[i]) - mesh.Position(keep));
    after.AddTo(mesh.Quadric(others[i]), 1.0);
    after.AddTo(mesh.Quadric(keep), 1.0);
  }
}
}

void SumRingQuadrics(HalfEdgeMesh& mesh, int threads)
{
  ForEachBlock(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), threads,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      RingSum sum(mesh);
      for (VertexId v = static_cast<Index>(first); v < static_cast<Index>(last); ++v)
      {
        if (mesh.Outgoing(v) != None && !mesh.IsConstrained(v))
        {
          mesh.Quadric(v) = sum.At(v);
        }
      }
    });
}

//------------------------------------------------------------------------------
void ExchangeRingQuadrics(HalfEdgeMesh& mesh, const EdgeNeighborhood& around, VertexId keep,
  const Vector3& origin, const Fan& fan)
{
  const Vector3 end(fan.End[0], fan.End[1], fan.End[2]);
  const double perArea = 1.0 / (mesh.Unit() * mesh.Unit());
  TakeGonePlanes(mesh, around, origin, end);
  mesh.Quadric(keep) =
    BestKernels().ExchangePlanes(fan, mesh.Records(), around.Ring.data(), !around.IsOpen, perArea);
  if (around.IsOpen)
  {
    ExchangeBoundaryEdges(mesh, around, keep, origin, end);
  }
}
}
