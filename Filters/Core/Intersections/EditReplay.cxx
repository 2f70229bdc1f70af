// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditReplay.h"

#include "Parallel.h"

namespace bonedecimate
{
namespace
{
FloatBox BoxAround(const std::vector<Piece>& old, const std::vector<Piece>& made, double reach)
{
  FloatBox box;
  for (const std::vector<Piece>* patch : { &old, &made })
  {
    for (const Piece& piece : *patch)
    {
      box.Add(FloatBox(piece.Corners, reach));
    }
  }
  return box;
}
}

std::vector<Index> EditReplay::FindRejected(const WrittenPositions& written, int threads)
{
  this->Boxes.resize(static_cast<std::size_t>(this->Journal.Count()));
  this->States.resize(this->Boxes.size(), State::Unchecked);
  const SpaceTimeTree undone = this->TakeUndone();
  ForEachChunk(this->Boxes.size(), threads, {},
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Workspace work;
      for (std::size_t i = first; i < last; ++i)
      {
        const Index edit = static_cast<Index>(i);
        if (this->States[i] == State::Undone)
        {
          continue;
        }
        bool isToCheck = this->States[i] != State::Accepted;
        undone.VisitAt(this->Boxes[i], edit, [&](std::size_t) { isToCheck = true; });
        if (isToCheck)
        {
          this->FillPatches(edit, work);
          this->Boxes[i] = BoxAround(work.Old, work.New, written.Rounding());
          this->States[i] =
            this->IsRejected(edit, written, work) ? State::Rejected : State::Accepted;
        }
      }
    });
  std::vector<Index> edits;
  for (Index edit = 0; edit < this->Journal.Count(); ++edit)
  {
    if (this->States[edit] == State::Rejected)
    {
      edits.push_back(edit);
    }
  }
  return edits;
}

//------------------------------------------------------------------------------
/// Takes what has been undone since the last check out of the history, later edits first. Where it was, and when.
SpaceTimeTree EditReplay::TakeUndone()
{
  if (!this->Faces)
  {
    this->Faces.emplace(this->Mesh, this->Journal);
  }
  std::vector<TimedBox> boxes;
  for (Index edit = this->Journal.Count(); edit-- > 0;)
  {
    State& state = this->States[edit];
    if (this->Journal.Entry(edit).IsUndone && state != State::Undone)
    {
      if (state != State::Unchecked)
      {
        this->Faces->Undo(edit);
        boxes.push_back({ this->Boxes[edit], edit, SpaceTimeTree::Never });
      }
      state = State::Undone;
    }
  }
  return SpaceTimeTree(std::move(boxes));
}

//------------------------------------------------------------------------------
void EditReplay::FillPatches(Index edit, Workspace& work) const
{
  work.Old.clear();
  work.New.clear();
  const JournalEntry& entry = this->Journal.Entry(edit);
  for (Index i = 0; i < entry.NumberOfFaces; ++i)
  {
    const FaceHistory::Version& old = this->Faces->OldFace(edit, i);
    work.Old.emplace_back(this->Mesh, old.Vertices, this->Faces->CornersOf(old));
    if (i >= entry.NumberOfGoneFaces)
    {
      const FaceHistory::Version& made = this->Faces->NewFace(edit, i);
      work.New.emplace_back(this->Mesh, made.Vertices, this->Faces->CornersOf(made));
    }
  }
}

//------------------------------------------------------------------------------
bool EditReplay::IsRejected(Index edit, const WrittenPositions& written, Workspace& work) const
{
  work.Near.clear();
  this->Faces->VisitAt(this->Boxes[edit], edit,
    [&](const FaceHistory::Version& version)
    { work.Near.emplace_back(this->Mesh, version.Vertices, this->Faces->CornersOf(version)); });
  return MeetMore(work.Old, work.New, work.Near, written) ||
    JumpOver(work.Old, work.New, work.Near);
}
}
