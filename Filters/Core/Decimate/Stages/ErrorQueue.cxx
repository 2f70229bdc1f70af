// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorQueue.h"

#include <algorithm>

namespace bonedecimate
{
ErrorQueue::ErrorQueue(Editor& editor, Samples& samples, OriginalHints& hints,
  SampledErrors& errors, const ErrorBlock& block)
  : MeshEditor(editor)
  , OriginalSamples(samples)
  , Hints(hints)
  , Errors(errors)
  , Block(block)
  , Fan(editor.Mesh(), samples, hints)
{
  this->Workspace.Change.Range = { block.First, block.End };
  this->Workspace.Change.Workers = block.Workers;
}

//------------------------------------------------------------------------------
bool ErrorQueue::Evaluate(const RatedEdge& edge, EvaluatedEdge& evaluated)
{
  if (!this->MeshEditor.Gather(edge.Edge, this->Workspace).IsAccepted())
  {
    return false;
  }
  const EdgeNeighborhood& around = this->Workspace.Neighborhood;
  const FanFit::Result result = this->Fan.Evaluate(around, edge.Position);
  evaluated = { result.Error - this->Errors.ErrorAround(around), edge.Edge, around.Start,
    around.End, this->Errors.StampOf(edge.Edge), result.Position };
  return true;
}

//------------------------------------------------------------------------------
void ErrorQueue::Take(const EvaluatedEdge& edge)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (mesh.Origin(edge.Edge) != edge.Start || mesh.Target(edge.Edge) != edge.End)
  {
    return; // removed
  }
  if (edge.Stamp != this->Errors.StampOf(edge.Edge))
  {
    this->Push({ 0.0F, edge.Edge, edge.Position });
  }
  else if (this->Collapse(edge))
  {
    ++this->Collapses;
  }
}

//------------------------------------------------------------------------------
void ErrorQueue::Push(const RatedEdge& edge)
{
  EvaluatedEdge evaluated;
  if (!this->Evaluate(edge, evaluated))
  {
    return;
  }
  if (evaluated.Cost > this->Block.Limit)
  {
    this->Remaining.push_back(evaluated);
  }
  else
  {
    this->Queue.push(evaluated);
  }
}

//------------------------------------------------------------------------------
bool ErrorQueue::Collapse(const EvaluatedEdge& edge)
{
  if (!this->MeshEditor.Gather(edge.Edge, this->Workspace).IsAccepted())
  {
    return false;
  }
  const EdgeNeighborhood around = this->Workspace.Neighborhood;
  if (!std::all_of(around.Ring.begin(), around.Ring.end(),
        [this](VertexId v) { return this->Block.Contains(v); }))
  {
    this->Remaining.push_back(edge);
    return false;
  }
  const FanFit::Result result = this->Fan.Evaluate(around, edge.Position);
  Edit edit;
  edit.Edge = edge.Edge;
  edit.Keep = around.Start;
  edit.Position = result.Position;
  this->Workspace.Change.Rank = static_cast<float>(edge.Cost);
  const Decision decision = this->MeshEditor.Try(edit, this->Workspace);
  if (!decision.IsAccepted())
  {
    if (decision.IsDeferred())
    {
      this->Remaining.push_back(edge);
    }
    return false;
  }
  this->OriginalSamples.HandOver(around.Faces(), this->Fan.Members());
  this->Hints.Set(edit.Keep, result.Hint);
  this->Errors.AfterCollapse(edit.Keep, result.VertexError);
  this->Candidates.clear();
  RateEdges(this->MeshEditor.Mesh(), edit.Keep, false, this->Candidates);
  for (const RatedEdge& candidate : this->Candidates)
  {
    if (candidate.Cost <= this->Block.MaxQuadricCost)
    {
      this->Push(candidate);
    }
  }
  return true;
}
}
