// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of SmoothingGraph for sharp edges.
#include "SmoothingGraph.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// The corners that two triangles have in common.
std::array<Index, 2> CommonEdge(const Surface& surface, const std::array<Index, 2>& triangles)
{
  const Triangle& other = surface.Triangles[triangles[1]];
  std::array<Index, 2> ends = { None, None };
  for (const Index corner : surface.Triangles[triangles[0]])
  {
    if (std::find(other.begin(), other.end(), corner) != other.end())
    {
      (ends[0] == None ? ends[0] : ends[1]) = corner;
    }
  }
  return ends;
}

/// The normal of a plane after its positions were converted to units.
Vector3 NormalInUnits(const Vector3& normal, const Eigen::Matrix3d& toUnits)
{
  const Vector3 turned = toUnits.inverse().transpose() * normal;
  const double length = turned.norm();
  return length > 0.0 ? Vector3(turned / length) : turned;
}
}

void SmoothingGraph::KeepSharp(
  const Surface& surface, const SharpEdges& sharp, const Eigen::Matrix3d& toUnits)
{
  this->MarkSharp(surface, sharp.IsSharp);
  this->AddProjections(surface, sharp, toUnits);
  this->CountWholeAlong(surface, sharp.IsSharp);
}

//------------------------------------------------------------------------------
std::int64_t SmoothingGraph::NumberOfSharpPoints() const
{
  return std::count_if(
    this->SharpStarts.begin(), this->SharpStarts.end(), [](Index start) { return start != None; });
}

//------------------------------------------------------------------------------
std::size_t SmoothingGraph::Find(Index point, Index neighbor) const
{
  const auto first = this->Neighbors.begin() + static_cast<std::ptrdiff_t>(this->Starts[point]);
  const auto last = this->Neighbors.begin() + static_cast<std::ptrdiff_t>(this->Starts[point + 1]);
  return static_cast<std::size_t>(
    std::lower_bound(first, last, neighbor) - this->Neighbors.begin());
}

//------------------------------------------------------------------------------
void SmoothingGraph::MarkSharp(const Surface& surface, const std::vector<char>& isSharp)
{
  this->SharpStarts.assign(this->Kinds.size(), None);
  this->NearSharpFlags.assign(this->Kinds.size(), 0);
  for (std::size_t e = 0; e < isSharp.size(); ++e)
  {
    if (isSharp[e] != 0)
    {
      const auto [a, b] = CommonEdge(surface, this->TrianglesOfEdges[e]);
      this->SharpStarts[a] = this->SharpStarts[b] = 0;
    }
  }
  std::size_t size = 0;
  for (std::size_t p = 0; p < this->SharpStarts.size(); ++p)
  {
    if (this->SharpStarts[p] != None)
    {
      this->SharpStarts[p] = static_cast<Index>(size);
      size += this->Starts[p + 1] - this->Starts[p];
      this->NearSharpFlags[p] = 1;
      this->VisitNeighbors(static_cast<Index>(p), [this](Index q) { this->NearSharpFlags[q] = 1; });
    }
  }
  this->Projections.assign(size, Eigen::Matrix3d::Zero());
}

//------------------------------------------------------------------------------
void SmoothingGraph::AddProjections(
  const Surface& surface, const SharpEdges& sharp, const Eigen::Matrix3d& toUnits)
{
  std::vector<int> counts(this->Projections.size(), 0);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& c = surface.Triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Index point = c[i];
      if (this->IsSharp(point))
      {
        const Vector3 n = NormalInUnits(sharp.Normals[t], toUnits);
        for (const Index neighbor : { c[(i + 1) % 3], c[(i + 2) % 3] })
        {
          const std::size_t slot =
            this->SharpStarts[point] + (this->Find(point, neighbor) - this->Starts[point]);
          this->Projections[slot] += n * n.transpose();
          ++counts[slot];
        }
      }
    }
  }
  for (std::size_t slot = 0; slot < counts.size(); ++slot)
  {
    this->Projections[slot] /= counts[slot];
  }
}

//------------------------------------------------------------------------------
/// Counts whole differences along sharp edges at points with two of them, so that the edges are
/// smoothed along themselves.
void SmoothingGraph::CountWholeAlong(const Surface& surface, const std::vector<char>& isSharp)
{
  std::vector<std::array<Index, 2>> alongs;
  std::vector<char> counts(this->Kinds.size(), 0);
  for (std::size_t e = 0; e < isSharp.size(); ++e)
  {
    if (isSharp[e] != 0)
    {
      const auto [a, b] = CommonEdge(surface, this->TrianglesOfEdges[e]);
      alongs.push_back({ a, b });
      alongs.push_back({ b, a });
      counts[a] = static_cast<char>(std::min(counts[a] + 1, 3));
      counts[b] = static_cast<char>(std::min(counts[b] + 1, 3));
    }
  }
  for (const auto& [point, neighbor] : alongs)
  {
    if (counts[point] == 2 && this->Kinds[point] == CurveKind::Interior)
    {
      const std::size_t k = this->Find(point, neighbor) - this->Starts[point];
      this->Projections[this->SharpStarts[point] + k] = Eigen::Matrix3d::Identity();
    }
  }
}

//------------------------------------------------------------------------------
Vector3 SmoothingGraph::TransposedRowNearSharp(Index point, const std::vector<Vector3>& z) const
{
  const bool isSharp = this->IsSharp(point);
  Vector3 sum = this->HasRow[point] != 0 && !isSharp ? z[point] : Vector3(Vector3::Zero());
  for (std::size_t k = this->Starts[point]; k < this->Starts[point + 1]; ++k)
  {
    if (isSharp)
    {
      sum += this->Weights[k] * (this->Projection(point, k) * z[point]);
    }
    const Index neighbor = this->Neighbors[k];
    const Vector3 z1 = this->IsSharp(neighbor)
      ? Vector3(this->Projection(neighbor, this->Find(neighbor, point)) * z[neighbor])
      : z[neighbor];
    sum -= this->TransposedWeights[k] * z1;
  }
  return sum;
}
}
