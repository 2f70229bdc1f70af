// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorQueue.h"

#include <algorithm>

namespace bonedecimate
{
ErrorQueue::ErrorQueue(Editor& editor, Samples& samples, BackHints& hints, SampledErrors& errors,
  const ErrorBlock& block)
  : Work(editor)
  , Fit(samples)
  , Back(hints)
  , Errors(errors)
  , Block(block)
  , Costs(editor.Mesh(), samples, hints)
{
  this->Space.Range = { block.First, block.Last };
}

//------------------------------------------------------------------------------
bool ErrorQueue::Judge(const RatedEdge& edge, JudgedEdge& judged)
{
  if (this->Work.Examine(edge.Edge, this->Space) != Verdict::Allowed)
  {
    return false;
  }
  const Neighbourhood& around = this->Space.Around;
  const FanFit::Answer answer = this->Costs.Evaluate(around, edge.Place);
  judged = { answer.Error - this->Errors.Around(around), edge.Edge, around.Start, around.End,
    this->Errors.StampOf(edge.Edge), answer.Position };
  return true;
}

//------------------------------------------------------------------------------
void ErrorQueue::Take(const JudgedEdge& edge)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  if (mesh.Origin(edge.Edge) != edge.Start || mesh.Target(edge.Edge) != edge.End)
  {
    return; // gone
  }
  if (edge.Stamp != this->Errors.StampOf(edge.Edge))
  {
    this->Push({ 0.0F, edge.Edge, edge.Place });
  }
  else if (this->Collapse(edge))
  {
    ++this->Collapses;
  }
}

//------------------------------------------------------------------------------
void ErrorQueue::Push(const RatedEdge& edge)
{
  JudgedEdge judged;
  if (!this->Judge(edge, judged))
  {
    return;
  }
  if (judged.Cost > this->Block.Limit)
  {
    this->Left.push_back(judged);
  }
  else
  {
    this->Queue.push(judged);
  }
}

//------------------------------------------------------------------------------
bool ErrorQueue::Collapse(const JudgedEdge& edge)
{
  if (this->Work.Examine(edge.Edge, this->Space) != Verdict::Allowed)
  {
    return false;
  }
  const Neighbourhood around = this->Space.Around;
  if (!std::all_of(
        around.Ring.begin(), around.Ring.end(), [this](Index v) { return this->Block.Holds(v); }))
  {
    this->Left.push_back(edge);
    return false;
  }
  const FanFit::Answer answer = this->Costs.Evaluate(around, edge.Place);
  Edit edit;
  edit.Edge = edge.Edge;
  edit.Keep = around.Start;
  edit.Position = answer.Position;
  this->Space.Rank = static_cast<float>(edge.Cost);
  const Verdict verdict = this->Work.Apply(edit, this->Space, this->Block.Workers);
  if (verdict != Verdict::Allowed)
  {
    if (verdict == Verdict::Elsewhere)
    {
      this->Left.push_back(edge);
    }
    return false;
  }
  this->HandOver(around);
  this->Back.Set(edit.Keep, answer.Hint);
  this->Errors.AfterCollapse(edit.Keep, answer.VertexError);
  this->Candidates.clear();
  RateEdges(this->Work.Mesh(), edit.Keep, false, this->Candidates);
  for (const RatedEdge& candidate : this->Candidates)
  {
    if (candidate.Cost <= this->Block.Dearest)
    {
      this->Push(candidate);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Gives the samples of all faces that were at the edge to those of the fan.
void ErrorQueue::HandOver(const Neighbourhood& around)
{
  for (const Index corner : around.Corners)
  {
    this->Fit.Take(HalfEdgeMesh::Face(corner));
  }
  this->Fit.Take(around.GoneFaces[0]);
  this->Fit.Take(around.GoneFaces[1]);
  for (const FanFit::Member& member : this->Costs.Members())
  {
    this->Fit.Put(member.Sample, HalfEdgeMesh::Face(around.Corners[member.Slot]));
  }
}
}
