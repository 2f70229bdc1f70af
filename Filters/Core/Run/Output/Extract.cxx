// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Extract.h"

#include "Base/Parallel.h"
#include "Mesh/SurfaceAssembly.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// For each vertex the number of input points merged into it.
std::vector<Index> CountPoints(const CleanSurface& clean, const std::vector<Index>& current)
{
  std::vector<Index> counts(current.size(), 0);
  for (std::size_t v = 0; v < current.size(); ++v)
  {
    counts[static_cast<std::size_t>(current[v])] += clean.InputPointCount[v];
  }
  return counts;
}

/// For each input point the index in the list of vertices of the one into which it was merged.
std::vector<Index> OutputPointsOfInput(const CleanSurface& clean, const std::vector<Index>& current,
  const std::vector<Index>& vertices, int threads)
{
  std::vector<Index> positions(current.size(), None);
  for (std::size_t p = 0; p < vertices.size(); ++p)
  {
    positions[static_cast<std::size_t>(vertices[p])] = static_cast<Index>(p);
  }
  std::vector<Index> ofInput(clean.PointOfInput.size(), None);
  ForEachId(ofInput.size(), threads,
    [&](std::size_t p)
    {
      const Index point = clean.PointOfInput[p];
      ofInput[p] = point == None ? None : positions[static_cast<std::size_t>(current[point])];
    });
  return ofInput;
}

/// The remaining vertices, and the original surface for look-ups.
struct Remains
{
  const CleanSurface& Clean;
  const Original& Source;
  std::vector<Index> Near;     // of each vertex, a triangle of the original
  std::vector<Index> Vertices; // of the mesh, a point of the result each
  std::vector<Vector3> Points; // mm from the local origin
};

/// Whether the triangles are those of the original, corner by corner:
/// smoothing alone has moved points.
bool HasTrianglesOf(const CleanSurface& clean, const HalfEdgeMesh& mesh)
{
  const std::vector<Triangle>& triangles = clean.Surface.Triangles;
  const auto isSame = [&](std::size_t face)
  {
    const auto id = static_cast<Index>(face);
    if (!mesh.IsAlive(id))
    {
      return false;
    }
    const Triangle c = mesh.Corners(id);
    Triangle own = { mesh.OriginalVertex(c[0]), mesh.OriginalVertex(c[1]),
      mesh.OriginalVertex(c[2]) };
    std::rotate(own.begin(), std::find(own.begin(), own.end(), triangles[face][0]), own.end());
    return own == triangles[face];
  };
  std::size_t face = 0;
  while (face < triangles.size() && isSame(face))
  {
    ++face;
  }
  return mesh.NumberOfFaces() == static_cast<Index>(face) && face == triangles.size();
}

/// A point or triangle that no edit has changed is its own origin.
void KeepOrigins(const Remains& remains, const HalfEdgeMesh& mesh, Result& result)
{
  const CleanSurface& clean = remains.Clean;
  for (const Index vertex : remains.Vertices)
  {
    const Index triangle = remains.Near[vertex];
    const Triangle& corners = clean.Surface.Triangles[triangle];
    std::array<double, 3> weights = { 0.0, 0.0, 0.0 };
    weights[std::find(corners.begin(), corners.end(), vertex) - corners.begin()] = 1.0;
    result.Origins.NearestTriangle.push_back(clean.InputTriangle[triangle]);
    result.Origins.Barycentric.push_back(weights);
    result.Origins.NearestPoint.push_back(clean.InputPoint[vertex]);
  }
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    result.Origins.TriangleAtCentroid.push_back(clean.InputTriangle[face]);
  }
}

/// Calls work for each point or triangle; the monitor cannot abort it.
template <typename LookUp>
void LookUpEach(std::size_t count, int threads, const Monitor& monitor, const LookUp& lookUp)
{
  const Monitor hear = [&](double done)
  {
    monitor(done);
    return true;
  };
  ForEachChunk(count, threads, hear,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        lookUp(i);
      }
    });
}

void LookUpPoints(const Remains& remains, const ExtractOptions& options, bool looksUpOrigins,
  const Monitor& monitor, Result& result)
{
  const BoundingTree& tree = remains.Source.Tree(options.Threads);
  const std::size_t count = remains.Points.size();
  const std::size_t origins = looksUpOrigins ? count : 0;
  result.Distance.resize(count);
  result.RunningError.resize(count);
  result.Origins.NearestTriangle.resize(origins);
  result.Origins.Barycentric.resize(origins);
  result.Origins.NearestPoint.resize(origins);
  LookUpEach(count, options.Threads, monitor,
    [&](std::size_t p)
    {
      const Index vertex = remains.Vertices[p];
      const BoundingTree::Nearest nearest =
        tree.FindNearest(remains.Points[p], remains.Near[vertex]);
      result.Distance[p] = std::sqrt(nearest.Point.SquaredDistance);
      result.RunningError[p] = remains.Source.RecordsDistances()
        ? remains.Source.RunningError(vertex)
        : result.Distance[p];
      if (looksUpOrigins)
      {
        result.Origins.NearestTriangle[p] = remains.Clean.InputTriangle[nearest.Triangle];
        result.Origins.Barycentric[p] = nearest.Point.Weights;
        result.Origins.NearestPoint[p] =
          remains.Clean.InputPoint[tree.FindNearestPoint(remains.Points[p], nearest.Triangle)];
      }
    });
}

/// Whether two input triangles have the same label, and the same labels on both sides.
bool HaveSameLabels(const ExtractOptions& options, std::size_t a, std::size_t b)
{
  const bool same = options.InputLabels == nullptr ||
    options.InputLabels->OfTriangle[a] == options.InputLabels->OfTriangle[b];
  return same &&
    (options.LabelMap == nullptr || options.LabelMap->OfTriangle.empty() ||
      options.LabelMap->OfTriangle[a] == options.LabelMap->OfTriangle[b]);
}

/// The triangle nearest to a centroid may have another label: the original triangle of the face is
/// used then.
void KeepLabels(const HalfEdgeMesh& mesh, const CleanSurface& clean, const ExtractOptions& options,
  Result& result)
{
  std::size_t next = 0;
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (mesh.IsAlive(face))
    {
      Index& triangle = result.Origins.TriangleAtCentroid[next++];
      const Index own = clean.InputTriangle[mesh.InputFace(face)];
      triangle =
        HaveSameLabels(options, static_cast<std::size_t>(triangle), static_cast<std::size_t>(own))
        ? triangle
        : own;
    }
  }
}

/// Faces keep their labels.
void CopyBoundaryLabels(
  const HalfEdgeMesh& mesh, const CleanSurface& clean, const LabelMapSource& source, Result& result)
{
  for (Index face = 0; face < mesh.NumberOfFaceSlots() && !source.OfTriangle.empty(); ++face)
  {
    if (mesh.IsAlive(face))
    {
      const Index triangle = clean.InputTriangle[mesh.InputFace(face)];
      result.BoundaryLabels.push_back(source.OfTriangle[static_cast<std::size_t>(triangle)]);
    }
  }
}

void LookUpCentroids(
  const Remains& remains, const ExtractOptions& options, const Monitor& monitor, Result& result)
{
  const BoundingTree& tree = remains.Source.Tree(options.Threads);
  const std::vector<Triangle>& triangles = result.Surface.Triangles;
  result.Origins.TriangleAtCentroid.resize(triangles.size());
  LookUpEach(triangles.size(), options.Threads, monitor,
    [&](std::size_t t)
    {
      const Triangle& c = triangles[t];
      const Vector3 centroid =
        (remains.Points[c[0]] + remains.Points[c[1]] + remains.Points[c[2]]) / 3.0;
      const Index triangle =
        tree.FindNearest(centroid, remains.Near[remains.Vertices[c[0]]]).Triangle;
      result.Origins.TriangleAtCentroid[t] = remains.Clean.InputTriangle[triangle];
    });
}

/// The distances of the points, and where points and triangles come from, as far as they are
/// requested.
void FindOrigins(const HalfEdgeMesh& mesh, Remains& remains, const ExtractOptions& options,
  const Monitor& monitor, Result& result)
{
  if (!options.Distances && !options.Origins)
  {
    return;
  }
  constexpr double pointsLookedUp = 0.5;
  const bool areKept = options.Origins && HasTrianglesOf(remains.Clean, mesh);
  const bool looksUpOrigins = options.Origins && !areKept;
  remains.Near = remains.Source.TrianglesAtPoints();
  LookUpPoints(remains, options, looksUpOrigins,
    PartOf(monitor, 0.0, looksUpOrigins ? pointsLookedUp : 1.0), result);
  if (areKept)
  {
    KeepOrigins(remains, mesh, result);
  }
  if (looksUpOrigins)
  {
    LookUpCentroids(remains, options, PartOf(monitor, pointsLookedUp, 1.0), result);
    KeepLabels(mesh, remains.Clean, options, result);
  }
}
}

std::vector<Vector3> Extract(const Surface& input, const CleanSurface& clean, const Editor& editor,
  const ExtractOptions& options, const Monitor& monitor, Result& result)
{
  const HalfEdgeMesh& mesh = editor.Mesh();
  result.Surface.Triangles = LiveTriangles(
    static_cast<std::size_t>(mesh.NumberOfFaceSlots()), options.Threads,
    [&](std::size_t face) { return mesh.IsAlive(static_cast<Index>(face)); },
    [&](std::size_t face)
    {
      const Triangle c = mesh.Corners(static_cast<Index>(face));
      return Triangle{ mesh.OriginalVertex(c[0]), mesh.OriginalVertex(c[1]),
        mesh.OriginalVertex(c[2]) };
    });
  if (options.LabelMap != nullptr)
  {
    CopyBoundaryLabels(mesh, clean, *options.LabelMap, result);
  }
  Remains remains = { clean, editor.Original(), {},
    NumberVertices(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), result.Surface.Triangles,
      options.Threads),
    {} };
  const std::vector<Index>& vertices = remains.Vertices;
  std::vector<Index> current = editor.Original().CurrentVertices();
  std::for_each(
    current.begin(), current.end(), [&](Index& vertex) { vertex = mesh.OriginalVertex(vertex); });
  const std::vector<Index> counts = CountPoints(clean, current);
  remains.Points.resize(vertices.size());
  result.Surface.Points.resize(vertices.size());
  result.PointCount.resize(vertices.size());
  ForEachId(vertices.size(), options.Threads,
    [&](std::size_t p)
    {
      const Vector3 position =
        OutputPosition(input, clean, vertices[p], mesh.Position(vertices[p]), options.Rounding);
      result.Surface.Points[p] = position;
      remains.Points[p] = position - clean.Origin;
      result.PointCount[p] = counts[static_cast<std::size_t>(vertices[p])];
    });
  FindOrigins(mesh, remains, options, monitor, result);
  if (options.Origins)
  {
    result.Origins.OutputPoint = OutputPointsOfInput(clean, current, vertices, options.Threads);
  }
  return std::move(remains.Points);
}
}
