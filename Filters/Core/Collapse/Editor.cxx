// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Editor.h"

#include "Gate.h"

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
