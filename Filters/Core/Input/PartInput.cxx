// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PartInput.h"

#include "LabelMapInput.h"
#include "Mesh/ManifoldPatches.h"
#include "Mesh/SpatialOrder.h"
#include "Parallel.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// The coordinates relative to another origin, computed from those of the input as cleaning would.
void SetOrigin(const Surface& input, const Vector3& origin, CleanSurface& clean)
{
  clean.Origin = origin;
  for (std::size_t v = 0; v < clean.Surface.Points.size(); ++v)
  {
    clean.Surface.Points[v] = input.Points[clean.InputPoint[v]] - origin;
  }
}

HalfEdgeMesh BuildMesh(const SurfacePart& part, int threads, CleanSurface& clean)
{
  SortAlongCurve(clean, threads);
  HalfEdgeMesh mesh(
    clean.Surface, threads, {}, PatchLabels(clean, part.ReferencePatches, part.ReferenceLabels));
  if (SplitIntoManifoldPatches(clean, mesh))
  {
    SortAlongCurve(clean, threads);
    mesh = HalfEdgeMesh(clean.Surface, threads, clean.ManifoldPatches);
  }
  return mesh;
}

/// Of each point the nearest triangle.
std::vector<Index> NearestTriangles(
  const std::vector<Vector3>& points, const BoundingTree& tree, int threads)
{
  std::vector<Index> nearest(points.size());
  ForEachId(points.size(), threads,
    [&](std::size_t i) { nearest[i] = tree.FindNearest(points[i]).Triangle; });
  return nearest;
}

/// Of the distance to the middle of its triangles, how far inside of a patch a point is searched.
constexpr double FromVertex = 0.25;

/// The points, but duplicates inside of their patch, because patches meet at the points themselves.
/// @param farthest mm
std::vector<Vector3> InsideOfPatches(const CleanSurface& clean, double farthest)
{
  std::vector<Vector3> points = clean.Surface.Points;
  const std::vector<Index>& originals = clean.ManifoldPatches.OriginalVertices;
  std::vector<char> isSplit(points.size(), 0);
  for (std::size_t v = 0; v < originals.size(); ++v)
  {
    if (originals[v] != static_cast<Index>(v))
    {
      isSplit[v] = isSplit[static_cast<std::size_t>(originals[v])] = 1;
    }
  }
  std::vector<Vector3> sums(originals.empty() ? 0 : points.size(), Vector3::Zero());
  std::vector<double> counts(sums.size(), 0.0);
  for (const Triangle& c : clean.Surface.Triangles)
  {
    const Vector3 middle =
      (clean.Surface.Points[c[0]] + clean.Surface.Points[c[1]] + clean.Surface.Points[c[2]]) / 3.0;
    for (std::size_t i = 0; i < 3 && !sums.empty(); ++i)
    {
      sums[c[i]] += middle;
      counts[c[i]] += 1.0;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
  {
    if (isSplit[v] != 0 && counts[v] > 0.0)
    {
      const Vector3 step = FromVertex * (sums[v] / counts[v] - points[v]);
      points[v] += std::min(1.0, farthest / std::max(step.norm(), farthest)) * step;
    }
  }
  return points;
}

/// Of each point the nearest corner of the nearest triangle.
std::vector<Index> NearestCorners(
  const std::vector<Vector3>& points, const Surface& surface, int threads)
{
  std::vector<Index> corners = NearestTriangles(points, BoundingTree(surface, threads), threads);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Triangle& c = surface.Triangles[corners[i]];
    const auto distance = [&](Index v) { return (surface.Points[v] - points[i]).squaredNorm(); };
    const Index first = distance(c[1]) < distance(c[0]) ? c[1] : c[0];
    corners[i] = distance(c[2]) < distance(first) ? c[2] : first;
  }
  return corners;
}
}

Neighborhood NeighborsOf(const SurfacePart& part, const CleanSurface& clean, int threads)
{
  if (part.Neighbors == nullptr || part.Neighbors->Triangles.empty())
  {
    return {};
  }
  Surface local = *part.Neighbors;
  for (Vector3& p : local.Points)
  {
    p -= clean.Origin;
  }
  return { std::make_shared<BoundingTree>(local, threads), part.NeighborDistance };
}

namespace
{
/// Marks the corners of triangles that are within the distance where edits start.
void MarkNear(const SurfacePart& part, const CleanSurface& clean, const Neighborhood& neighbors,
  std::vector<char>& marks)
{
  const auto position = [&](Index vertex) -> Vector3
  {
    const Index point = clean.InputPoint[vertex];
    return part.SmoothedPoints.empty() ? clean.Surface.Points[vertex]
                                       : part.SmoothedPoints[point] - clean.Origin;
  };
  const std::vector<Index>& originals = clean.ManifoldPatches.OriginalVertices;
  for (const Triangle& c : clean.Surface.Triangles)
  {
    if (MayComeNear(*neighbors.Others, { position(c[0]), position(c[1]), position(c[2]) },
          neighbors.Distance))
    {
      for (const Index corner : c)
      {
        marks[originals.empty() ? corner : originals[static_cast<std::size_t>(corner)]] = 1;
      }
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<char> SharedVertices(
  const SurfacePart& part, const CleanSurface& clean, const Neighborhood& neighbors)
{
  std::vector<char> isShared;
  if (part.IsShared.empty() && !neighbors.Others)
  {
    return isShared;
  }
  isShared.resize(clean.Surface.Points.size(), 0);
  for (std::size_t i = 0; i < part.IsShared.size(); ++i)
  {
    const Index point = clean.PointOfInput[i];
    if (point != None && part.IsShared[i] != 0)
    {
      isShared[static_cast<std::size_t>(point)] = 1;
    }
  }
  if (neighbors.Others)
  {
    MarkNear(part, clean, neighbors, isShared);
  }
  const std::vector<Index>& originals = clean.ManifoldPatches.OriginalVertices;
  for (std::size_t v = 0; v < originals.size(); ++v)
  {
    isShared[v] = isShared[static_cast<std::size_t>(originals[v])];
  }
  return isShared;
}

//------------------------------------------------------------------------------
CutEdges CutEdgesOf(const std::vector<std::array<Index, 2>>& edges, const CleanSurface& clean)
{
  std::vector<std::array<Index, 2>> cleaned;
  cleaned.reserve(edges.size());
  for (const auto& [a, b] : edges)
  {
    if (clean.PointOfInput[a] != None && clean.PointOfInput[b] != None)
    {
      cleaned.push_back({ clean.PointOfInput[a], clean.PointOfInput[b] });
    }
  }
  return CutEdges(std::move(cleaned));
}

//------------------------------------------------------------------------------
std::optional<Zone> LocalZone(const std::optional<Zone>& zone, const CleanSurface& clean)
{
  std::optional<Zone> local = zone;
  if (local)
  {
    const double origin = local->Direction.dot(clean.Origin);
    local->Low -= origin;
    local->High -= origin;
  }
  return local;
}

//------------------------------------------------------------------------------
std::unique_ptr<ReferenceMesh> MakeReferenceMesh(
  const SurfacePart& part, const CleanSurface& input, const Options& options)
{
  const int threads = options.NumberOfThreads;
  CleanSurface clean = Clean(*part.Reference, options.MergePoints, threads);
  if (clean.Status != InputStatus::Good)
  {
    return nullptr;
  }
  SetOrigin(*part.Reference, input.Origin, clean);
  HalfEdgeMesh mesh = BuildMesh(part, threads, clean);
  CutEdges cuts = CutEdgesOf(part.ReferenceCutEdges, clean);
  BoundingTree tree(clean.Surface, threads);
  const double farthest = 0.5 * options.MaximumError;
  std::vector<Index> nearVertex =
    NearestCorners(InsideOfPatches(clean, farthest), input.Surface, threads);
  std::vector<Index> nearTriangle =
    NearestTriangles(InsideOfPatches(input, farthest), tree, threads);
  return std::make_unique<ReferenceMesh>(ReferenceMesh{ std::move(clean), std::move(mesh),
    std::move(cuts), std::move(tree), std::move(nearVertex), std::move(nearTriangle) });
}
}
