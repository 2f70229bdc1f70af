// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditRecorder.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
void EditRecorder::Add(std::vector<LoggedCollapse>& collapses)
{
  this->Log.Collapses.insert(this->Log.Collapses.end(), collapses.begin(), collapses.end());
  collapses.clear();
}

//------------------------------------------------------------------------------
void EditRecorder::AddMerged(const std::vector<std::vector<LoggedCollapse>*>& lists)
{
  const auto first = static_cast<std::ptrdiff_t>(this->Log.Collapses.size());
  for (std::vector<LoggedCollapse>* list : lists)
  {
    float highest = -std::numeric_limits<float>::infinity();
    for (LoggedCollapse& collapse : *list)
    {
      highest = std::max(highest, collapse.Rank);
      collapse.Rank = highest;
    }
    this->Add(*list);
  }
  std::stable_sort(this->Log.Collapses.begin() + first, this->Log.Collapses.end(),
    [](const LoggedCollapse& a, const LoggedCollapse& b) { return a.Rank < b.Rank; });
}

//------------------------------------------------------------------------------
void EditRecorder::BeginPatch(const HalfEdgeMesh& mesh)
{
  this->CornersBefore.resize(static_cast<std::size_t>(mesh.NumberOfFaceSlots()));
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    this->CornersBefore[static_cast<std::size_t>(face)] = mesh.Corners(face);
  }
  this->PositionsBefore.resize(static_cast<std::size_t>(mesh.NumberOfVertexSlots()));
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    this->PositionsBefore[static_cast<std::size_t>(v)] = mesh.Position(v);
  }
}

//------------------------------------------------------------------------------
void EditRecorder::EndPatch(const HalfEdgeMesh& mesh)
{
  LoggedPatch patch;
  patch.Collapses = static_cast<Index>(this->Log.Collapses.size());
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    const Triangle corners = mesh.Corners(face);
    if (corners != this->CornersBefore[static_cast<std::size_t>(face)])
    {
      patch.Faces.push_back({ face, corners });
    }
  }
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
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
