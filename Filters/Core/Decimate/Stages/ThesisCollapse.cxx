// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThesisCollapse.h"

#include "Decimate/Placement/PlaneQuadric.h"
#include "Mesh/MeanEdgeLength.h"

#include <algorithm>

namespace bonedecimate
{
ThesisCollapse::ThesisCollapse(Editor& editor, const QueuePolicies& policies, double tolerance)
  : MeshEditor(editor)
  , End(editor, {})
  , Policies(policies)
  , Costs(policies.Cost(editor.Mesh(), editor.Areas(), tolerance, MeanEdgeLength(editor.Mesh())))
  , Queue(editor.Mesh().NumberOfVertexSlots())
{
}

//------------------------------------------------------------------------------
StopReason ThesisCollapse::Run(const StopTargets& stops, const Monitor& monitor)
{
  this->End.Restart(stops);
  if (!this->End.IsReached())
  {
    for (VertexId v = 0; v < this->MeshEditor.Mesh().NumberOfVertexSlots(); ++v)
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
    if (!this->End.Report(monitor))
    {
      return StopReason::Aborted;
    }
  }
  return this->End.Reason();
}

//------------------------------------------------------------------------------
bool ThesisCollapse::CollapseAt(VertexId vertex)
{
  this->EdgesOfVertex.clear();
  this->MeshEditor.Mesh().VisitEdges(vertex,
    [&](HalfEdgeId h) {
      this->EdgesOfVertex.push_back({ this->Costs->OfEdge(h), h });
    });
  std::sort(this->EdgesOfVertex.begin(), this->EdgesOfVertex.end(),
    [](const CostedEdge& a, const CostedEdge& b)
    { return a.Cost != b.Cost ? a.Cost < b.Cost : a.Edge < b.Edge; });
  const bool isCollapsed = std::any_of(this->EdgesOfVertex.begin(), this->EdgesOfVertex.end(),
    [this](const CostedEdge& candidate) { return this->CollapseEdge(candidate.Edge); });
  this->MeshEditor.Settle(&this->Workspace.Counts);
  return isCollapsed;
}

//------------------------------------------------------------------------------
bool ThesisCollapse::CollapseEdge(HalfEdgeId edge)
{
  if (!this->MeshEditor.Gather(edge, this->Workspace).IsAccepted())
  {
    return false;
  }
  const PositionCandidates proposals = this->Policies.Placement(
    this->MeshEditor.Mesh(), this->MeshEditor.Areas(), this->Workspace.Neighborhood);
  for (std::size_t i = 0; i < proposals.Count; ++i)
  {
    const Edit& edit = proposals.Edits[i];
    const VertexId gone = this->MeshEditor.Mesh().OtherEnd(edge, edit.Keep);
    if (this->MeshEditor.Try(edit, this->Workspace).IsAccepted())
    {
      this->Queue.Remove(gone);
      this->Recost(edit.Keep);
      this->MeshEditor.Mesh().VisitEdges(edit.Keep,
        [&](HalfEdgeId h) { this->Recost(this->MeshEditor.Mesh().OtherEnd(h, edit.Keep)); });
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void ThesisCollapse::Recost(VertexId vertex)
{
  if (this->MeshEditor.Mesh().Outgoing(vertex) == None || IsHub(this->MeshEditor.Mesh(), vertex))
  {
    this->Queue.Remove(vertex);
  }
  else if (!this->MeshEditor.Mesh().IsConstrained(vertex))
  {
    this->Queue.Set(vertex, this->Costs->OfVertex(vertex));
  }
}
}
