// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorQueue.h"

#include <algorithm>

namespace bonedecimate
{
ErrorQueue::ErrorQueue(Editor& editor, Samples& samples, OriginalHints& hints,
  SampledErrors& errors, const ErrorBlock& block)
  : MeshEditor(editor)
  , Fit(samples)
  , Back(hints)
  , Errors(errors)
  , Block(block)
  , Costs(editor.Mesh(), samples, hints)
{
  this->Space.Change.Range = { block.First, block.Last };
  this->Space.Change.Workers = block.Workers;
}

//------------------------------------------------------------------------------
bool ErrorQueue::Evaluate(const RatedEdge& edge, EvaluatedEdge& evaluated)
{
  if (!this->MeshEditor.Gather(edge.Edge, this->Space).IsAccepted())
  {
    return false;
  }
  const EdgeNeighborhood& around = this->Space.Around;
  const FanFit::Result result = this->Costs.Evaluate(around, edge.Position);
  evaluated = { result.Error - this->Errors.Around(around), edge.Edge, around.Start, around.End,
    this->Errors.StampOf(edge.Edge), result.Position };
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
    this->Left.push_back(evaluated);
  }
  else
  {
    this->Queue.push(evaluated);
  }
}

//------------------------------------------------------------------------------
bool ErrorQueue::Collapse(const EvaluatedEdge& edge)
{
  if (!this->MeshEditor.Gather(edge.Edge, this->Space).IsAccepted())
  {
    return false;
  }
  const EdgeNeighborhood around = this->Space.Around;
  if (!std::all_of(around.Ring.begin(), around.Ring.end(),
        [this](VertexId v) { return this->Block.Holds(v); }))
  {
    this->Left.push_back(edge);
    return false;
  }
  const FanFit::Result result = this->Costs.Evaluate(around, edge.Position);
  Edit edit;
  edit.Edge = edge.Edge;
  edit.Keep = around.Start;
  edit.Position = result.Position;
  this->Space.Change.Rank = static_cast<float>(edge.Cost);
  const Decision decision = this->MeshEditor.Try(edit, this->Space);
  if (!decision.IsAccepted())
  {
    if (decision.IsDeferred())
    {
      this->Left.push_back(edge);
    }
    return false;
  }
  this->Fit.HandOver(around.Faces(), this->Costs.Members());
  this->Back.Set(edit.Keep, result.Hint);
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
