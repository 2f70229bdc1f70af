// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThesisLoop.h"

#include "Mesh/MeanEdgeLength.h"
#include "Placement/PlaneQuadric.h"

#include <algorithm>

namespace bonedecimate
{
ThesisLoop::ThesisLoop(Editor& editor, double tolerance, const Stops& stops)
  : Work(editor)
  , End(editor, stops)
  , Costs(editor.Mesh(), editor.Areas(), tolerance, MeanEdgeLength(editor.Mesh()))
  , Queue(editor.Mesh().NumberOfVertexSlots())
{
}

//------------------------------------------------------------------------------
StopReason ThesisLoop::Run(const Monitor& monitor)
{
  if (!this->End.IsReached())
  {
    for (Index v = 0; v < this->Work.Mesh().NumberOfVertexSlots(); ++v)
    {
      this->Recost(v);
    }
  }
  while (!this->End.IsReached())
  {
    if (this->Queue.IsEmpty())
    {
      return StopReason::NothingLeft;
    }
    this->CollapseAt(this->Queue.PopLowest());
    if (!this->End.Tell(monitor))
    {
      return StopReason::Aborted;
    }
  }
  return this->End.Reason();
}

//------------------------------------------------------------------------------
StopReason ThesisLoop::RunTo(const Stops& stops, const Monitor& monitor)
{
  this->End.Set(stops);
  return this->Run(monitor);
}

//------------------------------------------------------------------------------
bool ThesisLoop::CollapseAt(Index vertex)
{
  this->EdgesOfVertex.clear();
  this->Work.Mesh().VisitEdges(vertex,
    [&](Index h) {
      this->EdgesOfVertex.push_back({ this->Costs.EdgeCost(h), h });
    });
  std::sort(this->EdgesOfVertex.begin(), this->EdgesOfVertex.end(),
    [](const CostedEdge& a, const CostedEdge& b)
    { return a.Cost != b.Cost ? a.Cost < b.Cost : a.Edge < b.Edge; });
  return std::any_of(this->EdgesOfVertex.begin(), this->EdgesOfVertex.end(),
    [this](const CostedEdge& candidate) { return this->CollapseEdge(candidate.Edge); });
}

//------------------------------------------------------------------------------
bool ThesisLoop::CollapseEdge(Index edge)
{
  if (this->Work.Examine(edge) != Verdict::Allowed)
  {
    return false;
  }
  const Proposals proposals =
    ProposePlaces(this->Work.Mesh(), this->Work.Areas(), this->Work.Around());
  for (std::size_t i = 0; i < proposals.Count; ++i)
  {
    const Edit& edit = proposals.Edits[i];
    const Index gone = this->Work.Mesh().Across(edge, edit.Keep);
    if (this->Work.Apply(edit) == Verdict::Allowed)
    {
      this->Queue.Remove(gone);
      this->Recost(edit.Keep);
      this->Work.Mesh().VisitEdges(
        edit.Keep, [&](Index h) { this->Recost(this->Work.Mesh().Across(h, edit.Keep)); });
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void ThesisLoop::Recost(Index vertex)
{
  if (this->Work.Mesh().Outgoing(vertex) == None)
  {
    this->Queue.Remove(vertex);
  }
  else if (!this->Work.Mesh().IsFixed(vertex))
  {
    this->Queue.Set(vertex, this->Costs.VertexCost(vertex));
  }
}
}
