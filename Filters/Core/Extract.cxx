// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Extract.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
/// Of each vertex of the mesh its output point, None for those that are gone; fills the triangles on the way.
std::vector<Index> NumberVertices(const HalfEdgeMesh& mesh, std::vector<Triangle>& triangles)
{
  std::vector<Index> number(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), None);
  triangles.reserve(static_cast<std::size_t>(mesh.NumberOfFaces()));
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (mesh.IsAlive(face))
    {
      triangles.push_back(mesh.Corners(face));
      for (const Index corner : triangles.back())
      {
        number[corner] = 0;
      }
    }
  }
  Index next = 0;
  for (Index& n : number)
  {
    n = n == None ? None : next++;
  }
  for (Triangle& corners : triangles)
  {
    corners = { number[corners[0]], number[corners[1]], number[corners[2]] };
  }
  return number;
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
  const bool moved = editor.Reference().Of(vertex).Moved;
  const Vector3 position = moved ? Vector3(editor.Mesh().Position(vertex) + clean.Origin)
                                 : input.Points[clean.InputPoint[vertex]];
  return roundToSingle ? Vector3(position.unaryExpr(&RoundedToSingle)) : position;
}

void AddPoint(const CleanSurface& clean, const Editor& editor, Index vertex, const Vector3& local,
  Result& result)
{
  const Original::Knowledge& known = editor.Reference().Of(vertex);
  const BoundingTree& tree = editor.Reference().Tree();
  const BoundingTree::Nearest nearest = tree.FindNearest(local, known.NearestTriangle);
  const Index nearestPoint = tree.FindNearestPoint(local, nearest.Triangle);
  result.Origins.NearestTriangle.push_back(clean.InputTriangle[nearest.Triangle]);
  result.Origins.Barycentric.push_back(nearest.Place.Weights);
  result.Origins.NearestPoint.push_back(clean.InputPoint[nearestPoint]);
  result.Distance.push_back(std::sqrt(nearest.Place.SquaredDistance));
  result.RunningError.push_back(
    editor.Reference().RecordsDistances() ? known.RunningError : result.Distance.back());
  result.PointCount.push_back(known.PointCount);
}
}

std::vector<Vector3> Extract(const Surface& input, const CleanSurface& clean, const Editor& editor,
  bool roundToSingle, Result& result)
{
  const std::vector<Index> number = NumberVertices(editor.Mesh(), result.Surface.Triangles);
  std::vector<Vector3> localPoints;
  for (Index vertex = 0; vertex < static_cast<Index>(number.size()); ++vertex)
  {
    if (number[vertex] == None)
    {
      continue;
    }
    const Vector3 position = GlobalPosition(input, clean, editor, vertex, roundToSingle);
    result.Surface.Points.push_back(position);
    localPoints.push_back(position - clean.Origin);
    AddPoint(clean, editor, vertex, localPoints.back(), result);
  }
  return localPoints;
}
}
