// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SharpEdges.h"

#include "Base/Parallel.h"
#include "Base/WorkspacePool.h"
#include "Geometry/Angle.h"
#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numeric>

namespace bonedecimate
{
namespace
{
/// In sums of the bends of two patches. Curvature alone explains at most 1.5.
constexpr double MaxOfBends = 2.0;

/// Whether two triangles at an edge have their normals on the same side of the surface.
bool HaveEqualOrientation(const Triangle& one, const Triangle& other)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      if (one[i] == other[(j + 1) % 3] && one[(i + 1) % 3] == other[j])
      {
        return true;
      }
    }
  }
  return false;
}

/// Neighbors of each triangle over edges that may be sharp, if their orientations agree; ascending
/// by edge.
class Neighbors
{
public:
  Neighbors(const std::vector<Triangle>& triangles, const std::vector<std::array<Index, 2>>& edges)
    : Starts(triangles.size() + 1, 0)
  {
    std::vector<std::array<Index, 2>> oriented;
    std::copy_if(edges.begin(), edges.end(), std::back_inserter(oriented),
      [&](const std::array<Index, 2>& edge)
      { return HaveEqualOrientation(triangles[edge[0]], triangles[edge[1]]); });
    for (const auto& [a, b] : oriented)
    {
      ++this->Starts[static_cast<std::size_t>(a) + 1];
      ++this->Starts[static_cast<std::size_t>(b) + 1];
    }
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end() - 1);
    this->NeighborList.resize(2 * oriented.size());
    for (const auto& [a, b] : oriented)
    {
      this->NeighborList[next[a]++] = b;
      this->NeighborList[next[b]++] = a;
    }
  }

  template <typename Visit>
  void VisitEach(Index triangle, const Visit& visit) const
  {
    for (std::size_t k = this->Starts[triangle]; k < this->Starts[triangle + 1]; ++k)
    {
      visit(this->NeighborList[k]);
    }
  }

private:
  std::vector<std::size_t> Starts;
  std::vector<Index> NeighborList;
};

/// Collects patches; one for each worker.
class Collector
{
public:
  explicit Collector(std::size_t triangles)
    : LastPatches(triangles, 0)
  {
  }

  /// The triangles connected to one, itself first.
  const std::vector<Index>& Collect(
    Index center, double radius, const std::vector<Vector3>& centroids, const Neighbors& neighbors)
  {
    ++this->Patch;
    this->Members.assign(1, center);
    this->LastPatches[center] = this->Patch;
    for (std::size_t i = 0; i < this->Members.size(); ++i)
    {
      neighbors.VisitEach(this->Members[i],
        [&](Index next)
        {
          if (this->LastPatches[next] != this->Patch &&
            (centroids[next] - centroids[center]).squaredNorm() <= radius * radius)
          {
            this->LastPatches[next] = this->Patch;
            this->Members.push_back(next);
          }
        });
    }
    return this->Members;
  }

private:
  std::vector<std::uint32_t> LastPatches; // the last patch of each triangle
  std::uint32_t Patch = 0;
  std::vector<Index> Members;
};

/// Bend in radians of the cap of a sphere with this spread.
double BendOf(double spread)
{
  const double cosine = 1.0 - 2.0 * spread;
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  return AngleBetween({ 1.0, 0.0, 0.0 }, { cosine, sine, 0.0 });
}

class NormalField
{
public:
  NormalField(const std::vector<Vector3>& points, const std::vector<Triangle>& triangles,
    const std::vector<std::array<Index, 2>>& edges, const SharpEdgeSettings& settings)
    : Settings(settings)
    , TriangleNeighbors(triangles, edges)
    , Centroids(triangles.size())
    , AreaVectors(triangles.size())
    , Means(triangles.size())
    , Spreads(triangles.size())
    , FlattestPatches(triangles.size())
  {
    ForEachId(triangles.size(), settings.Threads,
      [&](std::size_t t)
      {
        const auto& [a, b, c] = triangles[t];
        this->Centroids[t] = settings.ToUnits * (points[a] + points[b] + points[c]) / 3.0;
        this->AreaVectors[t] = AreaVector(points[a], points[b], points[c]);
      });
    this->ForEachPatch(
      [this](Index t, const std::vector<Index>& patch) { this->Summarize(t, patch); });
    this->ForEachPatch([this](Index t, const std::vector<Index>& patch)
      { this->FlattestPatches[t] = this->Flattest(patch); });
  }

  bool IsSharp(const std::array<Index, 2>& edge) const
  {
    const Index a = this->FlattestPatches[edge[0]];
    const Index b = this->FlattestPatches[edge[1]];
    const double angle = AngleBetween(this->Means[a], this->Means[b]);
    return DegreesPerRadian * angle > this->Settings.Angle &&
      angle > MaxOfBends * (BendOf(this->Spreads[a]) + BendOf(this->Spreads[b]));
  }

  const Vector3& Normal(Index triangle) const
  {
    return this->Means[this->FlattestPatches[triangle]];
  }

private:
  template <typename Work>
  void ForEachPatch(const Work& work)
  {
    ForEachBlock(this->Centroids.size(), this->Settings.Threads,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        const std::shared_ptr<Collector> collector = this->Collectors.Borrow(
          [this] { return std::make_unique<Collector>(this->Centroids.size()); });
        for (std::size_t t = first; t < last; ++t)
        {
          const auto triangle = static_cast<Index>(t);
          work(triangle,
            collector->Collect(
              triangle, this->Settings.Scale, this->Centroids, this->TriangleNeighbors));
        }
      });
  }

  void Summarize(Index triangle, const std::vector<Index>& patch)
  {
    Vector3 sum = Vector3::Zero();
    double area = 0.0;
    for (const Index member : patch)
    {
      sum += this->AreaVectors[member];
      area += this->AreaVectors[member].norm();
    }
    const double length = sum.norm();
    this->Means[triangle] = length > 0.0 ? Vector3(sum / length) : sum;
    this->Spreads[triangle] = area > 0.0 ? std::clamp(1.0 - length / area, 0.0, 1.0) : 1.0;
  }

  Index Flattest(const std::vector<Index>& patch) const
  {
    return *std::min_element(patch.begin(), patch.end(),
      [this](Index a, Index b) {
        return this->Spreads[a] != this->Spreads[b] ? this->Spreads[a] < this->Spreads[b] : a < b;
      });
  }

  const SharpEdgeSettings& Settings;
  Neighbors TriangleNeighbors;
  WorkspacePool<Collector> Collectors;
  std::vector<Vector3> Centroids;
  std::vector<Vector3> AreaVectors;
  std::vector<Vector3> Means;         // of the patch of each triangle
  std::vector<double> Spreads;        // of the patch of each triangle
  std::vector<Index> FlattestPatches; // whose patch gives the normal of each triangle
};
}

SharpEdges FindSharpEdges(const std::vector<Vector3>& points,
  const std::vector<Triangle>& triangles, const std::vector<std::array<Index, 2>>& edges,
  const SharpEdgeSettings& settings)
{
  const NormalField field(points, triangles, edges, settings);
  SharpEdges found;
  found.IsSharp.resize(edges.size());
  ForEachId(edges.size(), settings.Threads,
    [&](std::size_t e)
    {
      const bool isOriented = HaveEqualOrientation(triangles[edges[e][0]], triangles[edges[e][1]]);
      found.IsSharp[e] = isOriented && field.IsSharp(edges[e]) ? 1 : 0;
    });
  found.Normals.resize(triangles.size());
  ForEachId(triangles.size(), settings.Threads,
    [&](std::size_t t) { found.Normals[t] = field.Normal(static_cast<Index>(t)); });
  return found;
}
}
