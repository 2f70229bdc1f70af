// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditReplay.h"

#include "Parallel.h"

namespace bonedecimate
{
namespace
{
FloatBox BoxAround(const std::vector<Piece>& old, const std::vector<Piece>& made)
{
  FloatBox box;
  for (const std::vector<Piece>* patch : { &old, &made })
  {
    for (const Piece& piece : *patch)
    {
      box.Add(FloatBox(piece.Corners));
    }
  }
  return box;
}
}

std::vector<Index> EditReplay::FindRejected(const FaceHistory& history, int threads)
{
  this->Boxes.resize(static_cast<std::size_t>(this->Journal.Count()));
  this->States.resize(this->Boxes.size(), State::Unchecked);
  const SpaceTimeTree undone = this->NewlyUndone();
  ForEachChunk(this->Boxes.size(), threads, {},
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Workspace work;
      for (std::size_t i = first; i < last; ++i)
      {
        const Index edit = static_cast<Index>(i);
        if (this->Journal.Entry(edit).IsUndone)
        {
          this->States[i] = State::Undone;
          continue;
        }
        bool isToCheck = this->States[i] != State::Accepted;
        undone.VisitAt(this->Boxes[i], edit, [&](std::size_t) { isToCheck = true; });
        if (isToCheck)
        {
          this->FillPatches(history, edit, work);
          this->Boxes[i] = BoxAround(work.Old, work.New);
          this->States[i] =
            this->IsRejected(history, edit, work) ? State::Rejected : State::Accepted;
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
/// Edits that have been undone since the last check.
SpaceTimeTree EditReplay::NewlyUndone() const
{
  std::vector<TimedBox> boxes;
  for (Index edit = 0; edit < this->Journal.Count(); ++edit)
  {
    if (this->Journal.Entry(edit).IsUndone &&
      (this->States[edit] == State::Accepted || this->States[edit] == State::Rejected))
    {
      boxes.push_back({ this->Boxes[edit], edit, SpaceTimeTree::Never });
    }
  }
  return SpaceTimeTree(std::move(boxes));
}

//------------------------------------------------------------------------------
void EditReplay::FillPatches(const FaceHistory& history, Index edit, Workspace& work) const
{
  work.Old.clear();
  work.New.clear();
  const JournalEntry& entry = this->Journal.Entry(edit);
  for (Index i = 0; i < entry.NumberOfFaces; ++i)
  {
    const FaceHistory::Version& old = history.OldFace(edit, i);
    work.Old.emplace_back(this->Mesh, old.Vertices, history.CornersOf(old));
    if (i >= entry.NumberOfGoneFaces)
    {
      const FaceHistory::Version& made = history.NewFace(edit, i);
      work.New.emplace_back(this->Mesh, made.Vertices, history.CornersOf(made));
    }
  }
}

//------------------------------------------------------------------------------
bool EditReplay::IsRejected(const FaceHistory& history, Index edit, Workspace& work) const
{
  work.Near.clear();
  history.VisitAt(this->Boxes[edit], edit,
    [&](const FaceHistory::Version& version)
    { work.Near.emplace_back(this->Mesh, version.Vertices, history.CornersOf(version)); });
  return MeetMore(work.Old, work.New, work.Near) || JumpOver(work.Old, work.New, work.Near);
}
}
