// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditReplay.h"

#include "Parallel.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
/// Versions in a window, of the faces of the input: more take memory, fewer take time.
constexpr double VersionsOfFaces = 1.3;
constexpr Index AllVersions = std::numeric_limits<Index>::max();
/// Of all edits, one in this many.
constexpr Index FewEdits = 8;

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
  const bool isFirst = this->States.empty();
  this->Boxes.resize(static_cast<std::size_t>(this->Journal.Count()));
  this->States.resize(this->Boxes.size(), State::Unchecked);
  const Index chosen = this->ChooseEdits(this->TakeUndone(), threads);
  const std::optional<SpaceTimeTree> region = isFirst ? std::nullopt : this->BoxesToCheck(chosen);
  FaceHistory history(this->Mesh, this->Journal, threads);
  while (history.FirstEdit() > 0 && chosen > 0)
  {
    history.GoBack(
      region ? AllVersions : static_cast<Index>(VersionsOfFaces * this->Mesh.NumberOfFaceSlots()),
      region ? &*region : nullptr);
    this->CheckWindow(history, written, threads);
  }
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
/// Notes what has been undone since the last check. Where it was, and when.
SpaceTimeTree EditReplay::TakeUndone()
{
  std::vector<TimedBox> boxes;
  for (Index edit = this->Journal.Count(); edit-- > 0;)
  {
    State& state = this->States[edit];
    if (this->Journal.Entry(edit).IsUndone && state != State::Undone)
    {
      if (state != State::Unchecked)
      {
        boxes.push_back({ this->Boxes[edit], edit, SpaceTimeTree::Never });
      }
      state = State::Undone;
    }
  }
  return SpaceTimeTree(std::move(boxes));
}

//------------------------------------------------------------------------------
/// Those that are rejected or near what is undone become unchecked. How many are.
Index EditReplay::ChooseEdits(const SpaceTimeTree& undone, int threads)
{
  ForEachId(this->States.size(), threads,
    [&](std::size_t i)
    {
      State& state = this->States[i];
      if (state == State::Accepted || state == State::Rejected)
      {
        bool isToCheck = state == State::Rejected;
        undone.VisitAt(
          this->Boxes[i], static_cast<Index>(i), [&](std::size_t) { isToCheck = true; });
        state = isToCheck ? State::Unchecked : state;
      }
    });
  return static_cast<Index>(std::count(this->States.begin(), this->States.end(), State::Unchecked));
}

//------------------------------------------------------------------------------
/// None if they are so many that it is not worth while to choose what is near them.
std::optional<SpaceTimeTree> EditReplay::BoxesToCheck(Index chosen) const
{
  if (chosen > this->Journal.Count() / FewEdits)
  {
    return std::nullopt;
  }
  std::vector<TimedBox> boxes;
  for (Index edit = 0; edit < this->Journal.Count(); ++edit)
  {
    if (this->States[edit] == State::Unchecked)
    {
      boxes.push_back({ this->Boxes[edit], edit, edit });
    }
  }
  return SpaceTimeTree(std::move(boxes));
}

//------------------------------------------------------------------------------
void EditReplay::CheckWindow(
  const FaceHistory& history, const WrittenPositions& written, int threads)
{
  // Near ones one after the other: faces lie along a curve that fills space.
  std::vector<std::pair<FaceId, Index>> edits;
  for (Index edit = history.FirstEdit(); edit < history.EndOfEdits(); ++edit)
  {
    if (this->States[edit] == State::Unchecked)
    {
      edits.emplace_back(this->Journal.OldFace(edit, 0).Face, edit);
    }
  }
  std::sort(edits.begin(), edits.end());
  ForEachChunk(edits.size(), threads, {},
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Workspace work;
      for (std::size_t i = first; i < last; ++i)
      {
        const Index edit = edits[i].second;
        this->FillPatches(edit, work);
        this->Boxes[edit] = BoxAround(work.Old, work.New, written.Rounding());
        this->States[edit] =
          this->IsRejected(history, edit, written, work) ? State::Rejected : State::Accepted;
      }
    });
}

//------------------------------------------------------------------------------
void EditReplay::FillPatches(Index edit, Workspace& work) const
{
  work.Old.clear();
  work.New.clear();
  const auto pieceOf = [this](const FaceVersion& face)
  { return Piece(this->Mesh, this->Journal.VerticesOf(face), this->Journal.CornersOf(face)); };
  for (Index i = 0; i < this->Journal.Entry(edit).NumberOfFaces; ++i)
  {
    work.Old.push_back(pieceOf(this->Journal.OldFace(edit, i)));
    if (i >= JournalEntry::NumberOfGoneFaces)
    {
      work.New.push_back(pieceOf(this->Journal.NewFace(edit, i)));
    }
  }
}

//------------------------------------------------------------------------------
bool EditReplay::IsRejected(
  const FaceHistory& history, Index edit, const WrittenPositions& written, Workspace& work) const
{
  work.Near.clear();
  history.VisitAt(this->Boxes[edit], edit,
    [&](const FaceVersion& face)
    {
      work.Near.emplace_back(
        this->Mesh, this->Journal.VerticesOf(face), this->Journal.CornersOf(face));
    });
  return MeetMore(work.Old, work.New, work.Near, written) ||
    JumpOver(work.Old, work.New, work.Near);
}
}
