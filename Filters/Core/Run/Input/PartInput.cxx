// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PartInput.h"

#include "LabelMapInput.h"
#include "Mesh/ManifoldPatches.h"
#include "Mesh/SpatialOrder.h"
#include "PatchSearch.h"

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
  if (SplitIntoManifoldPatches(
        clean, threads, PatchLabels(clean, part.ReferencePatches, part.ReferenceLabels)))
  {
    SortAlongCurve(clean, threads);
  }
  return HalfEdgeMesh(clean.Surface, threads, clean.ManifoldPatches);
}

/// The corner of each triangle that is nearest to its point.
std::vector<Index> NearestCorners(
  const std::vector<Vector3>& points, const Surface& surface, std::vector<Index> triangles)
{
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const Triangle& c = surface.Triangles[triangles[i]];
    const auto distance = [&](Index v) { return (surface.Points[v] - points[i]).squaredNorm(); };
    const Index first = distance(c[1]) < distance(c[0]) ? c[1] : c[0];
    triangles[i] = distance(c[2]) < distance(first) ? c[2] : first;
  }
  return triangles;
}
}

NeighborSurfaces NeighborsOf(const SurfacePart& part, const CleanSurface& clean, int threads)
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
void MarkNear(const SurfacePart& part, const CleanSurface& clean, const NeighborSurfaces& neighbors,
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
  const SurfacePart& part, const CleanSurface& clean, const NeighborSurfaces& neighbors)
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
    const double origin = Dot(local->Direction, clean.Origin);
    local->Low -= origin;
    local->High -= origin;
  }
  return local;
}

//------------------------------------------------------------------------------
std::unique_ptr<ReferenceMesh> MakeReferenceMesh(
  const RunInputs& inputs, const CleanSurface& input, const Options& options)
{
  const SurfacePart& part = *inputs.Part;
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
  const SurfaceOfPatches original = { clean, part.ReferencePatches, part.ReferenceLabels };
  const SurfaceOfPatches current = { input, inputs.Labels, inputs.LabelMap };
  const double farthest = 0.5 * options.MaximumError;
  std::vector<Index> nearVertex = NearestCorners(
    clean.Surface.Points, input.Surface, NearestInPatch(original, current, farthest, threads));
  std::vector<Index> nearTriangle = NearestInPatch(current, original, farthest, threads);
  return std::make_unique<ReferenceMesh>(ReferenceMesh{ std::move(clean), std::move(mesh),
    std::move(cuts), std::move(tree), std::move(nearVertex), std::move(nearTriangle) });
}
}
