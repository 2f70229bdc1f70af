// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PartInput.h"

#include "LabelMapInput.h"
#include "Mesh/ManifoldPatches.h"
#include "Mesh/SpatialOrder.h"
#include "Parallel.h"

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

HalfEdgeMesh BuildMesh(const LabelMapSource* labels, int threads, CleanSurface& clean)
{
  SortAlongCurve(clean, threads);
  HalfEdgeMesh mesh(clean.Surface, threads, {}, PatchLabels(clean, nullptr, labels));
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

std::vector<char> SharedVertices(const SurfacePart* part, const CleanSurface& clean)
{
  std::vector<char> isShared;
  if (part == nullptr || part->IsShared.empty())
  {
    return isShared;
  }
  isShared.resize(clean.Surface.Points.size(), 0);
  for (std::size_t i = 0; i < part->IsShared.size(); ++i)
  {
    const Index point = clean.PointOfInput[i];
    if (point != None && part->IsShared[i] != 0)
    {
      isShared[static_cast<std::size_t>(point)] = 1;
    }
  }
  const std::vector<Index>& originals = clean.ManifoldPatches.OriginalVertices;
  for (std::size_t v = 0; v < originals.size(); ++v)
  {
    isShared[v] = isShared[static_cast<std::size_t>(originals[v])];
  }
  return isShared;
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
  HalfEdgeMesh mesh = BuildMesh(part.ReferenceLabels, threads, clean);
  BoundingTree tree(clean.Surface, threads);
  std::vector<Index> nearVertex = NearestCorners(clean.Surface.Points, input.Surface, threads);
  std::vector<Index> nearTriangle = NearestTriangles(input.Surface.Points, tree, threads);
  return std::make_unique<ReferenceMesh>(ReferenceMesh{ std::move(clean), std::move(mesh),
    std::move(tree), std::move(nearVertex), std::move(nearTriangle) });
}
}
