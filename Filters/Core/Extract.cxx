// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Extract.h"

#include "Parallel.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
/// The corners of the faces that are alive.
std::vector<Triangle> LiveTriangles(const HalfEdgeMesh& mesh, int threads)
{
  const auto slots = static_cast<std::size_t>(mesh.NumberOfFaceSlots());
  const auto isAlive = [&](std::size_t face) { return mesh.IsAlive(static_cast<Index>(face)); };
  std::vector<std::size_t> starts = StartsOfBlocks(slots, threads, isAlive);
  std::vector<Triangle> triangles(starts.back());
  ForEachBlock(slots, threads,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t next = starts[block];
      for (std::size_t face = first; face < last; ++face)
      {
        if (isAlive(face))
        {
          triangles[next++] = mesh.Corners(static_cast<Index>(face));
        }
      }
    });
  return triangles;
}

/// The vertices that are corners, ascending; the corners become places in this list.
std::vector<Index> NumberVertices(
  std::size_t vertexSlots, std::vector<Triangle>& triangles, int threads)
{
  std::vector<Index> number(vertexSlots, None);
  for (const Triangle& corners : triangles)
  {
    number[corners[0]] = number[corners[1]] = number[corners[2]] = 0;
  }
  std::vector<Index> vertices;
  vertices.reserve(triangles.size());
  for (std::size_t v = 0; v < vertexSlots; ++v)
  {
    if (number[v] != None)
    {
      number[v] = static_cast<Index>(vertices.size());
      vertices.push_back(static_cast<Index>(v));
    }
  }
  ForEachId(triangles.size(), threads,
    [&](std::size_t t)
    {
      Triangle& c = triangles[t];
      c = { number[c[0]], number[c[1]], number[c[2]] };
    });
  return vertices;
}

/// Optimisers take the way to single precision and back for nothing (gcc 12 does at -O2): volatile makes it real.
double RoundedToSingle(double value)
{
  const volatile float rounded = static_cast<float>(value);
  return static_cast<double>(rounded);
}

Vector3 GlobalPosition(const Surface& input, const CleanSurface& clean, const Editor& editor,
  Index vertex, bool roundToSingle)
{
  const Vector3& local = editor.Mesh().Position(vertex);
  const Vector3 position = editor.Reference().HasMoved(vertex, local)
    ? Vector3(local + clean.Origin)
    : input.Points[clean.InputPoint[vertex]];
  return roundToSingle ? Vector3(position.unaryExpr(&RoundedToSingle)) : position;
}

/// Of each vertex: how many input points it stands for.
std::vector<Index> CountPoints(const CleanSurface& clean, const Original& original)
{
  const std::vector<Index> current = original.CurrentVertices();
  std::vector<Index> counts(current.size(), 0);
  for (std::size_t v = 0; v < current.size(); ++v)
  {
    counts[static_cast<std::size_t>(current[v])] += clean.InputPointCount[v];
  }
  return counts;
}

/// Looks every point up on the original.
void FillMaps(const CleanSurface& clean, const Editor& editor, const std::vector<Index>& vertices,
  const std::vector<Vector3>& localPoints, const ExtractOptions& options, const Monitor& monitor,
  Result& result)
{
  const Original& original = editor.Reference();
  const BoundingTree& tree = original.Tree(options.Threads);
  const std::vector<Index> near = original.TrianglesAtPoints();
  const std::size_t origins = options.Origins ? vertices.size() : 0;
  result.Distance.resize(vertices.size());
  result.RunningError.resize(vertices.size());
  result.Origins.NearestTriangle.resize(origins);
  result.Origins.Barycentric.resize(origins);
  result.Origins.NearestPoint.resize(origins);
  const auto lookUp = [&](std::size_t p)
  {
    const BoundingTree::Nearest nearest =
      tree.FindNearest(localPoints[p], near[static_cast<std::size_t>(vertices[p])]);
    result.Distance[p] = std::sqrt(nearest.Place.SquaredDistance);
    result.RunningError[p] =
      original.RecordsDistances() ? original.RunningError(vertices[p]) : result.Distance[p];
    if (options.Origins)
    {
      result.Origins.NearestTriangle[p] = clean.InputTriangle[nearest.Triangle];
      result.Origins.Barycentric[p] = nearest.Place.Weights;
      result.Origins.NearestPoint[p] =
        clean.InputPoint[tree.FindNearestPoint(localPoints[p], nearest.Triangle)];
    }
  };
  const Monitor hear = [&](double done)
  {
    monitor(done);
    return true;
  };
  ForEachChunk(vertices.size(), options.Threads, hear,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t p = first; p < last; ++p)
      {
        lookUp(p);
      }
    });
}
}

std::vector<Vector3> Extract(const Surface& input, const CleanSurface& clean, const Editor& editor,
  const ExtractOptions& options, const Monitor& monitor, Result& result)
{
  const HalfEdgeMesh& mesh = editor.Mesh();
  result.Surface.Triangles = LiveTriangles(mesh, options.Threads);
  const std::vector<Index> vertices =
    NumberVertices(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), result.Surface.Triangles,
      options.Threads);
  const std::vector<Index> counts = CountPoints(clean, editor.Reference());
  std::vector<Vector3> localPoints(vertices.size());
  result.Surface.Points.resize(vertices.size());
  result.PointCount.resize(vertices.size());
  ForEachId(vertices.size(), options.Threads,
    [&](std::size_t p)
    {
      const Vector3 position =
        GlobalPosition(input, clean, editor, vertices[p], options.RoundToSingle);
      result.Surface.Points[p] = position;
      localPoints[p] = position - clean.Origin;
      result.PointCount[p] = counts[static_cast<std::size_t>(vertices[p])];
    });
  if (options.Distances || options.Origins)
  {
    FillMaps(clean, editor, vertices, localPoints, options, monitor, result);
  }
  return localPoints;
}
}
