// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothingGraph.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bonedecimate
{
namespace
{
/// Shorter edges than this fraction of the median count as this long: needles would dominate their
/// rows.
constexpr double ShortestEdge = 0.6;
constexpr double FactorOfWalls = 0.1; // at a junction

CurveKind KindOfEdge(std::size_t triangles, bool sameLabels)
{
  return triangles == 1            ? CurveKind::Boundary
    : triangles == 2 && sameLabels ? CurveKind::Interior
                                   : CurveKind::Junction;
}
}

SmoothingGraph::SmoothingGraph(const Surface& surface, const std::vector<BoundaryLabels>& labels,
  const Eigen::Matrix3d& toUnits, int threads)
  : Threads(threads)
  , Kinds(surface.Points.size(), CurveKind::Interior)
  , HasRow(surface.Points.size(), 0)
{
  this->FindNeighbors(surface, labels);
  this->WeighEdges(surface.Points, toUnits);
  this->Normalize();
  this->EdgeKinds = {};
}

//------------------------------------------------------------------------------
/// Lists the triangles at each point twice, with both of their other corners.
void SmoothingGraph::FindNeighbors(
  const Surface& surface, const std::vector<BoundaryLabels>& labels)
{
  std::vector<std::size_t> starts(surface.Points.size() + 1, 0);
  for (const Triangle& corners : surface.Triangles)
  {
    for (const Index corner : corners)
    {
      starts[static_cast<std::size_t>(corner) + 1] += 2;
    }
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
  std::vector<Incidence> incidences(starts.back());
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& c = surface.Triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      incidences[next[c[i]]++] = { c[(i + 1) % 3], static_cast<Index>(t) };
      incidences[next[c[i]]++] = { c[(i + 2) % 3], static_cast<Index>(t) };
    }
  }
  ForEachId(surface.Points.size(), this->Threads,
    [&](std::size_t p)
    {
      std::sort(incidences.begin() + static_cast<std::ptrdiff_t>(starts[p]),
        incidences.begin() + static_cast<std::ptrdiff_t>(starts[p + 1]),
        [](const Incidence& a, const Incidence& b)
        { return a.Neighbor != b.Neighbor ? a.Neighbor < b.Neighbor : a.Triangle < b.Triangle; });
    });
  this->ReadNeighbors(incidences, starts, labels);
}

//------------------------------------------------------------------------------
void SmoothingGraph::ReadNeighbors(const std::vector<Incidence>& sorted,
  const std::vector<std::size_t>& starts, const std::vector<BoundaryLabels>& labels)
{
  this->Starts.reserve(starts.size());
  this->Neighbors.reserve(sorted.size() / 2);
  this->EdgeKinds.reserve(sorted.size() / 2);
  this->TrianglesOfEdges.reserve(sorted.size() / 4);
  for (std::size_t p = 0; p + 1 < starts.size(); ++p)
  {
    this->Starts.push_back(this->Neighbors.size());
    for (std::size_t first = starts[p], last = first; first < starts[p + 1]; first = last)
    {
      while (last < starts[p + 1] && sorted[last].Neighbor == sorted[first].Neighbor)
      {
        ++last;
      }
      const Index a = sorted[first].Triangle;
      const Index b = sorted[last - 1].Triangle;
      const CurveKind kind = KindOfEdge(last - first, labels.empty() || labels[a] == labels[b]);
      this->Neighbors.push_back(sorted[first].Neighbor);
      this->EdgeKinds.push_back(kind);
      // A boundary that ends at a junction is smoothed along itself there, too.
      this->Kinds[p] = this->Kinds[p] == CurveKind::Boundary || kind == CurveKind::Interior
        ? this->Kinds[p]
        : kind;
      if (kind == CurveKind::Interior && static_cast<Index>(p) < sorted[first].Neighbor)
      {
        this->TrianglesOfEdges.push_back({ a, b });
      }
    }
  }
  this->Starts.push_back(this->Neighbors.size());
}

//------------------------------------------------------------------------------
/// The weight of each edge, the same from both ends.
void SmoothingGraph::WeighEdges(const std::vector<Vector3>& points, const Eigen::Matrix3d& toUnits)
{
  this->Weights.resize(this->Neighbors.size());
  ForEachId(points.size(), this->Threads,
    [&](std::size_t p)
    {
      for (std::size_t k = this->Starts[p]; k < this->Starts[p + 1]; ++k)
      {
        this->Weights[k] = (toUnits * (points[p] - points[this->Neighbors[k]])).norm();
      }
    });
  std::vector<double> lengths = this->Weights; // every edge twice
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  this->MedianEdgeLength = lengths.empty() ? 0.0 : *middle;
  const double shortest = ShortestEdge * this->MedianEdgeLength;
  ForEachId(this->Weights.size(), this->Threads,
    [&](std::size_t k)
    {
      // A ratio, so that weights do not depend on the units.
      const double ratio = shortest > 0.0 ? shortest / std::max(this->Weights[k], shortest) : 1.0;
      this->Weights[k] = ratio * ratio;
    });
}

//------------------------------------------------------------------------------
double SmoothingGraph::Factor(Index point, CurveKind edge) const
{
  if (edge != CurveKind::Interior)
  {
    return 1.0;
  }
  const CurveKind kind = this->Kinds[point];
  return kind == CurveKind::Interior ? 1.0 : kind == CurveKind::Boundary ? 0.0 : FactorOfWalls;
}

//------------------------------------------------------------------------------
void SmoothingGraph::Normalize()
{
  std::vector<double> perSum(this->Kinds.size(), 0.0);
  const auto factor = [this](std::size_t point, std::size_t k)
  { return this->Weights[k] * this->Factor(static_cast<Index>(point), this->EdgeKinds[k]); };
  ForEachId(perSum.size(), this->Threads,
    [&](std::size_t p)
    {
      double sum = 0.0;
      for (std::size_t k = this->Starts[p]; k < this->Starts[p + 1]; ++k)
      {
        sum += factor(p, k);
      }
      this->HasRow[p] = sum > 0.0 ? 1 : 0;
      perSum[p] = sum > 0.0 ? 1.0 / sum : 0.0;
    });
  this->TransposedWeights.resize(this->Weights.size());
  ForEachId(perSum.size(), this->Threads,
    [&](std::size_t p)
    {
      for (std::size_t k = this->Starts[p]; k < this->Starts[p + 1]; ++k)
      {
        const auto neighbor = static_cast<std::size_t>(this->Neighbors[k]);
        this->TransposedWeights[k] = factor(neighbor, k) * perSum[neighbor];
        this->Weights[k] = factor(p, k) * perSum[p];
      }
    });
}

//------------------------------------------------------------------------------
double SmoothingGraph::ColumnBound(Index point) const
{
  double sum = this->HasRow[point];
  for (std::size_t k = this->Starts[point]; k < this->Starts[point + 1]; ++k)
  {
    sum += this->TransposedWeights[k];
  }
  return 2.0 * sum;
}
}
