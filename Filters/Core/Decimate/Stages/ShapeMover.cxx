// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeMover.h"

#include "Decimate/Edit/FlipAndMoveRules.h"
#include "EdgesByLength.h"
#include "FaceShape.h"

#include <algorithm>
#include <array>
#include <utility>

namespace bonedecimate
{
void ShapeMover::FlipAt(FaceId face)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  std::array<std::pair<double, HalfEdgeId>, 3> edges; // by their squared lengths
  for (Index k = 0; k < 3; ++k)
  {
    const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, k);
    edges[static_cast<std::size_t>(k)] = { SquaredLength(mesh, h), h };
  }
  std::stable_sort(
    edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& edge : edges)
  {
    if (this->TryFlip(edge.second))
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
bool ShapeMover::TryFlip(HalfEdgeId edge)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (mesh.Twin(edge) == None)
  {
    return false;
  }
  const auto [a, b, c, d] = PositionsOf(mesh, CornersAround(mesh, edge));
  const double before = std::max(CosineOfSmallestAngle(a, b, c), CosineOfSmallestAngle(b, a, d));
  const double after = std::max(CosineOfSmallestAngle(a, d, c), CosineOfSmallestAngle(b, c, d));
  return after < before - MinGainOfCosine &&
    this->MeshEditor.Try(FlipOf(edge), this->Workspace).IsAccepted();
}

//------------------------------------------------------------------------------
void ShapeMover::MoveAt(FaceId face)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  for (const Index corner : mesh.Corners(face))
  {
    if (CosineOfFace(mesh, face) > this->Enough)
    {
      this->Move(corner);
    }
  }
}

//------------------------------------------------------------------------------
void ShapeMover::Move(VertexId vertex)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (!MayMove(mesh, vertex))
  {
    return;
  }
  this->Ring.Gather(mesh, vertex);
  const Vector3 from = mesh.Position(vertex);
  const double before = this->Ring.CosineAt(from);
  double after = before;
  const Vector3 found = this->Ring.Search(from, this->Enough, after);
  const double worst = before - MinGainOfCosine;
  if (!(after < worst))
  {
    return;
  }
  const BoundingTree& tree = this->MeshEditor.Original().BoundedTree();
  const Vector3 there = tree.FindNearest(found).Point.Position;
  const Vector3 offset = from - tree.FindNearest(from).Point.Position;
  for (const Vector3& position : { Vector3(there + offset), there, found,
         Vector3(0.5 * (there + from)), Vector3(0.5 * (found + from)) })
  {
    if (this->Ring.CosineAt(position, worst) < worst &&
      this->MeshEditor.Try(MoveTo(vertex, position), this->Workspace).IsAccepted())
    {
      return;
    }
  }
}
}
