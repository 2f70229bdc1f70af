// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeImprover.h"

#include "FaceShape.h"
#include "ShapeMover.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr int MostRounds = 12;
/// The cosine of 45 degrees: where angles are smaller, flips and moves make collapses possible.
constexpr double Relaxed = 0.7071067811865476;
/// Edits between two calls of a monitor.
constexpr std::size_t EditsOfCall = 64;

/// Calls work(i) for each index. False if the monitor requests a stop.
template <typename Work>
bool ForEachOf(std::size_t count, const Monitor& monitor, const Work& work)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    work(i);
    if (i % EditsOfCall == 0 && !monitor(static_cast<double>(i) / static_cast<double>(count)))
    {
      return false;
    }
  }
  return monitor(1.0);
}

double SquaredLength(const HalfEdgeMesh& mesh, HalfEdgeId edge)
{
  return (mesh.Position(mesh.Target(edge)) - mesh.Position(mesh.Origin(edge))).squaredNorm();
}
}

bool ShapeImprover::Mend(const Monitor& monitor)
{
  constexpr double collapsedAt = 0.4; // of a round
  std::size_t before = this->FindBadFaces().size();
  bool goesOn = true;
  for (int round = 0; round < MostRounds && before > 0 && goesOn; ++round)
  {
    const Monitor tell =
      PartOf(monitor, static_cast<double>(round) / MostRounds, (round + 1.0) / MostRounds);
    goesOn = this->ForEachBadFace(
               PartOf(tell, 0.0, collapsedAt), [this](FaceId face) { this->CollapseAt(face); }) &&
      this->FlipAndMove(PartOf(tell, collapsedAt, 1.0));
    const std::size_t now = this->FindBadFaces().size();
    before = now < before ? now : 0;
  }
  return goesOn && monitor(1.0);
}

//------------------------------------------------------------------------------
bool ShapeImprover::IsBad(FaceId face) const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  return mesh.IsAlive(face) && CosineOfFace(mesh, face) > this->LargestCosine;
}

//------------------------------------------------------------------------------
/// The worst first.
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
/// Edits on the way may mend other faces or remove them.
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
/// At bad faces.
bool ShapeImprover::FlipAndMove(const Monitor& monitor)
{
  constexpr double flippedAt = 0.3;
  ShapeMover mover(this->MeshEditor, this->LargestCosine);
  this->MeshEditor.DistributeVolumeBudget();
  this->MeshEditor.BeginFlipsAndMoves();
  const bool goesOn = this->ForEachBadFace(PartOf(monitor, 0.0, flippedAt),
                        [&mover](FaceId face) { mover.FlipAt(face); }) &&
    this->ForEachBadFace(
      PartOf(monitor, flippedAt, 1.0), [&mover](FaceId face) { mover.MoveAt(face); });
  mover.Settle();
  this->MeshEditor.EndFlipsAndMoves();
  return goesOn;
}

//------------------------------------------------------------------------------
/// At all faces with a smallest angle below 45 degrees.
bool ShapeImprover::Relax(const Monitor& monitor)
{
  constexpr double flippedAt = 0.2;
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  ShapeMover mover(this->MeshEditor, Relaxed);
  this->MeshEditor.DistributeVolumeBudget();
  this->MeshEditor.BeginFlipsAndMoves();
  const bool goesOn =
    ForEachOf(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), PartOf(monitor, 0.0, flippedAt),
      [&](std::size_t i)
      {
        const FaceId face = static_cast<Index>(i);
        if (mesh.IsAlive(face) && CosineOfFace(mesh, face) > Relaxed)
        {
          mover.FlipAt(face);
        }
      }) &&
    ForEachOf(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), PartOf(monitor, flippedAt, 1.0),
      [&](std::size_t i)
      {
        const VertexId vertex = static_cast<Index>(i);
        if (mesh.Outgoing(vertex) != None)
        {
          mover.Move(vertex);
        }
      });
  mover.Settle();
  this->MeshEditor.EndFlipsAndMoves();
  return goesOn;
}

//------------------------------------------------------------------------------
/// The shortest edge that may be.
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
    if (this->Edges.Try(edge.second))
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
bool ShapeImprover::Collapse(Index faces, const Monitor& monitor)
{
  constexpr double relaxedAt = 0.4;
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (!this->Relax(PartOf(monitor, 0.0, relaxedAt)))
  {
    return false;
  }
  std::vector<std::pair<double, Index>> edges;
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    for (Index k = 0; k < 3 && mesh.IsAlive(face); ++k)
    {
      const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, k);
      if (mesh.Twin(h) == None || h < mesh.Twin(h))
      {
        edges.emplace_back(SquaredLength(mesh, h), h);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  return ForEachOf(edges.size(), PartOf(monitor, relaxedAt, 1.0),
    [&](std::size_t i)
    {
      const auto& [length, edge] = edges[i];
      const bool isUnchanged =
        mesh.IsAlive(HalfEdgeMesh::Face(edge)) && SquaredLength(mesh, edge) == length;
      if (isUnchanged && mesh.NumberOfFaces() > faces)
      {
        this->Edges.Try(edge);
      }
    });
}
}
