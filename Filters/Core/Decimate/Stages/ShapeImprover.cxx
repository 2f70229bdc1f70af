// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeImprover.h"

#include "EdgesByLength.h"
#include "FaceShape.h"
#include "ShapeLoop.h"
#include "ShapeMover.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
bool ShapeImprover::Mend(const Monitor& monitor)
{
  constexpr double collapsedAt = 0.4; // of a round
  constexpr int maxRounds = 12;
  std::size_t before = this->FindBadFaces().size();
  bool shouldContinue = true;
  for (int round = 0; round < maxRounds && before > 0 && shouldContinue; ++round)
  {
    const Monitor tell = StepOf(monitor, round, maxRounds);
    shouldContinue = this->ForEachBadFace(PartOf(tell, 0.0, collapsedAt),
                       [this](FaceId face) { this->CollapseAt(face); }) &&
      this->FlipAndMove(PartOf(tell, collapsedAt, 1.0));
    const std::size_t now = this->FindBadFaces().size();
    before = now < before ? now : 0;
  }
  return shouldContinue && monitor(1.0);
}

//------------------------------------------------------------------------------
bool ShapeImprover::IsBad(FaceId face) const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  return mesh.IsAlive(face) && CosineOfFace(mesh, face) > this->MaxCosine;
}

//------------------------------------------------------------------------------
/// Bad faces, worst first.
std::vector<Index> ShapeImprover::FindBadFaces() const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  std::vector<std::pair<double, Index>> found;
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (this->IsBad(face))
    {
      found.emplace_back(-CosineOfFace(mesh, face), face);
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<Index> faces;
  std::transform(found.begin(), found.end(), std::back_inserter(faces),
    [](const auto& entry) { return entry.second; });
  return faces;
}

//------------------------------------------------------------------------------
/// Earlier edits may improve or remove other faces.
template <typename Improve>
bool ShapeImprover::ForEachBadFace(const Monitor& monitor, const Improve& improve)
{
  const std::vector<Index> faces = this->FindBadFaces();
  return ForEachOf(faces.size(), monitor,
    [&](std::size_t i)
    {
      if (this->IsBad(faces[i]))
      {
        improve(faces[i]);
      }
    });
}

//------------------------------------------------------------------------------
/// Flips and moves at bad faces.
bool ShapeImprover::FlipAndMove(const Monitor& monitor)
{
  constexpr double flippedAt = 0.3;
  ShapeMover mover(this->MeshEditor, this->MaxCosine);
  const auto flipAndMove = [&]
  {
    return this->ForEachBadFace(
             PartOf(monitor, 0.0, flippedAt), [&mover](FaceId face) { mover.FlipAt(face); }) &&
      this->ForEachBadFace(
        PartOf(monitor, flippedAt, 1.0), [&mover](FaceId face) { mover.MoveAt(face); });
  };
  return this->MeshEditor.FlipAndMove(flipAndMove, &mover.OwnWorkspace());
}

//------------------------------------------------------------------------------
bool ShapeImprover::Relax(Editor& editor, const Monitor& monitor)
{
  constexpr double flippedAt = 0.2;
  const HalfEdgeMesh& mesh = editor.Mesh();
  ShapeMover mover(editor, CosineOfRelaxed);
  const auto flip = [&](std::size_t i)
  {
    const FaceId face = static_cast<Index>(i);
    if (mesh.IsAlive(face) && CosineOfFace(mesh, face) > CosineOfRelaxed)
    {
      mover.FlipAt(face);
    }
  };
  const auto move = [&](std::size_t i)
  {
    const VertexId vertex = static_cast<Index>(i);
    if (mesh.Outgoing(vertex) != None)
    {
      mover.Move(vertex);
    }
  };
  const auto flipAndMove = [&]
  {
    return ForEachOf(static_cast<std::size_t>(mesh.NumberOfFaceSlots()),
             PartOf(monitor, 0.0, flippedAt), flip) &&
      ForEachOf(static_cast<std::size_t>(mesh.NumberOfVertexSlots()),
        PartOf(monitor, flippedAt, 1.0), move);
  };
  return editor.FlipAndMove(flipAndMove, &mover.OwnWorkspace());
}

//------------------------------------------------------------------------------
/// Collapses the shortest edge of the face that can be collapsed.
void ShapeImprover::CollapseAt(FaceId face)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  std::array<std::pair<double, Index>, 3> edges;
  for (Index k = 0; k < 3; ++k)
  {
    const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, k);
    edges[static_cast<std::size_t>(k)] = { SquaredLength(mesh, h), h };
  }
  std::sort(edges.begin(), edges.end());
  for (const auto& edge : edges)
  {
    if (this->Collapser.Try(edge.second))
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
bool ShapeImprover::Collapse(Index faces, const Monitor& monitor)
{
  constexpr double relaxedAt = 0.4;
  if (!Relax(this->MeshEditor, PartOf(monitor, 0.0, relaxedAt)))
  {
    return false;
  }
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const std::vector<EdgeOfLength> edges = EdgesByLength(mesh);
  return ForEachOf(edges.size(), PartOf(monitor, relaxedAt, 1.0),
    [&](std::size_t i)
    {
      if (IsUnchanged(mesh, edges[i]) && mesh.NumberOfFaces() > faces)
      {
        this->Collapser.Try(edges[i].Edge);
      }
    });
}
}
