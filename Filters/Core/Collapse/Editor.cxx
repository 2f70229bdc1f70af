// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Editor.h"

#include "Gate.h"
#include "SmallEdits.h"

namespace bonedecimate
{
Editor::Editor(const CleanSurface& clean, bool recordDistances)
  : Half(clean.Surface)
  , FaceGeometry(this->Half)
  , Source(clean, recordDistances)
  , Volumes(this->Half, clean.Surface)
  , Gatherer(this->Half)
{
}

//------------------------------------------------------------------------------
Verdict Editor::Count(Verdict verdict)
{
  if (verdict != Verdict::Allowed)
  {
    ++this->RefusalsByVerdict[static_cast<std::size_t>(verdict)];
  }
  return verdict;
}

//------------------------------------------------------------------------------
Verdict Editor::JudgeEdge(Index edge)
{
  const Verdict ends = JudgeEnds(this->Half, edge);
  if (ends != Verdict::Allowed)
  {
    return ends;
  }
  this->Gatherer.Gather(this->Half, edge, this->Examined);
  const Verdict topology = JudgeTopology(this->Half, this->Examined);
  if (topology != Verdict::Allowed)
  {
    this->Examined.Edge = None;
  }
  return topology;
}

//------------------------------------------------------------------------------
Verdict Editor::Examine(Index edge)
{
  return this->Count(this->JudgeEdge(edge));
}

//------------------------------------------------------------------------------
Verdict Editor::Apply(const Edit& edit)
{
  if (this->Examined.Edge != edit.Edge)
  {
    const Verdict verdict = this->Examine(edit.Edge);
    if (verdict != Verdict::Allowed)
    {
      return verdict;
    }
  }
  const Verdict place = JudgePlace(this->Half, this->FaceGeometry, this->Examined, edit);
  if (place != Verdict::Allowed)
  {
    return this->Count(place);
  }
  const double volumeChange = VolumeChange(this->Half, this->Examined, edit);
  if (!this->Volumes.MayChange(edit.Keep, volumeChange))
  {
    return this->Count(Verdict::Fragment);
  }
  const Index gone = this->Half.Across(edit.Edge, edit.Keep);
  this->Half.Collapse(edit.Edge, edit.Keep, edit.Position);
  this->KeepBooks(edit, gone, volumeChange);
  return Verdict::Allowed;
}

//------------------------------------------------------------------------------
Verdict Editor::ApplySmall(const Edit& edit)
{
  const Verdict verdict = edit.Kind == EditKind::Flip ? this->ApplyFlip(edit.Edge)
                                                      : this->ApplyMove(edit.Keep, edit.Position);
  if (verdict == Verdict::Allowed && this->AfterEdit)
  {
    this->AfterEdit(*this, edit);
  }
  return verdict;
}

//------------------------------------------------------------------------------
void Editor::LookUpVertices()
{
  for (Index v = 0; v < this->Half.NumberOfVertexSlots(); ++v)
  {
    if (this->Half.Outgoing(v) != None)
    {
      this->Source.LookUp(v, this->Half.Position(v));
    }
  }
}

//------------------------------------------------------------------------------
Verdict Editor::ApplyFlip(Index edge)
{
  const Verdict topology = JudgeFlipTopology(this->Half, edge);
  if (topology != Verdict::Allowed)
  {
    return topology;
  }
  const Verdict place = JudgeFlipPlace(this->Half, this->FaceGeometry, edge);
  if (place != Verdict::Allowed)
  {
    return place;
  }
  const Index vertex = this->Half.Origin(edge);
  if (!this->Volumes.ShareAllows(vertex, FlipVolumeChange(this->Half, edge)))
  {
    return Verdict::Fragment;
  }
  this->Half.Flip(edge);
  this->FaceGeometry.Update(this->Half, HalfEdgeMesh::Face(edge));
  this->FaceGeometry.Update(this->Half, HalfEdgeMesh::Face(this->Half.Twin(edge)));
  return Verdict::Allowed;
}

//------------------------------------------------------------------------------
Verdict Editor::ApplyMove(Index vertex, const Vector3& position)
{
  const Verdict place = JudgeMove(this->Half, this->FaceGeometry, vertex, position);
  if (place != Verdict::Allowed)
  {
    return place;
  }
  const double change = MoveVolumeChange(this->Half, this->FaceGeometry, vertex, position);
  if (!this->Volumes.ShareAllows(vertex, change))
  {
    return Verdict::Fragment;
  }
  this->Half.Move(vertex, position);
  this->Source.Move(vertex);
  for (const Index h : this->Half.OutgoingOf(vertex))
  {
    this->FaceGeometry.Update(this->Half, HalfEdgeMesh::Face(h));
  }
  return Verdict::Allowed;
}

//------------------------------------------------------------------------------
void Editor::KeepBooks(const Edit& edit, Index gone, double volumeChange)
{
  for (const Index h : this->Examined.Corners)
  {
    this->FaceGeometry.Update(this->Half, HalfEdgeMesh::Face(h));
  }
  this->Examined.Edge = None;
  this->Source.Merge(edit.Keep, gone, edit.Position, edit.KeepStays);
  this->Volumes.Change(edit.Keep, volumeChange);
  ++this->Edits;
  if (this->AfterEdit)
  {
    this->AfterEdit(*this, edit);
  }
}
}
