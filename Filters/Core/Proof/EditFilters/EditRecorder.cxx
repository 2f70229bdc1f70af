// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditRecorder.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
void EditRecorder::Commit(const HalfEdgeMesh&, const SurfaceChange& change, Pending&, Tally& tally)
{
  const Edit& collapse = change.Requested;
  if (collapse.Kind == EditKind::Collapse)
  {
    tally.Log.push_back(
      { collapse.Position, collapse.Edge, change.SecondRemovedFace, collapse.Keep, change.Rank });
  }
}

//------------------------------------------------------------------------------
void EditRecorder::Settle(Tally* tallies, std::size_t count)
{
  if (count == 1)
  {
    this->Add(tallies->Log);
  }
  else
  {
    this->AddMerged(tallies, count);
  }
}

//------------------------------------------------------------------------------
void EditRecorder::Add(std::vector<LoggedCollapse>& collapses)
{
  this->Log.Collapses.insert(this->Log.Collapses.end(), collapses.begin(), collapses.end());
  collapses.clear();
}

//------------------------------------------------------------------------------
void EditRecorder::AddMerged(Tally* tallies, std::size_t count)
{
  const auto first = static_cast<std::ptrdiff_t>(this->Log.Collapses.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    float highest = -std::numeric_limits<float>::infinity();
    for (LoggedCollapse& collapse : tallies[i].Log)
    {
      highest = std::max(highest, collapse.Rank);
      collapse.Rank = highest;
    }
    this->Add(tallies[i].Log);
  }
  std::stable_sort(this->Log.Collapses.begin() + first, this->Log.Collapses.end(),
    [](const LoggedCollapse& a, const LoggedCollapse& b) { return a.Rank < b.Rank; });
}

//------------------------------------------------------------------------------
/// A patch belongs to the level of the collapse before it, so no level ends between them.
void EditRecorder::AddNearby(
  const std::vector<VertexMove>& moves, const std::vector<SurfaceChange::Face>& faces)
{
  LoggedPatch patch;
  patch.Collapses = static_cast<Index>(this->Log.Collapses.size());
  for (const VertexMove& move : moves)
  {
    patch.Vertices.push_back({ move.Vertex, move.Position });
  }
  for (const SurfaceChange::Face& face : faces)
  {
    patch.Faces.push_back({ face.Id, face.Vertices });
  }
  this->Log.Patches.push_back(std::move(patch));
}

//------------------------------------------------------------------------------
void EditRecorder::BeginPatch(const HalfEdgeMesh& mesh)
{
  this->CornersBefore.resize(static_cast<std::size_t>(mesh.NumberOfFaceSlots()));
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    this->CornersBefore[static_cast<std::size_t>(face)] = mesh.Corners(face);
  }
  this->PositionsBefore.resize(static_cast<std::size_t>(mesh.NumberOfVertexSlots()));
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    this->PositionsBefore[static_cast<std::size_t>(v)] = mesh.Position(v);
  }
}

//------------------------------------------------------------------------------
void EditRecorder::EndPatch(const HalfEdgeMesh& mesh)
{
  LoggedPatch patch;
  patch.Collapses = static_cast<Index>(this->Log.Collapses.size());
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    const Triangle corners = mesh.Corners(face);
    if (corners != this->CornersBefore[static_cast<std::size_t>(face)])
    {
      patch.Faces.push_back({ face, corners });
    }
  }
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.Position(v) != this->PositionsBefore[static_cast<std::size_t>(v)])
    {
      patch.Vertices.push_back({ v, mesh.Position(v) });
    }
  }
  if (!patch.Faces.empty() || !patch.Vertices.empty())
  {
    this->Log.Patches.push_back(std::move(patch));
  }
}
}
