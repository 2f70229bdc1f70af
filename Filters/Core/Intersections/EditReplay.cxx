// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditReplay.h"

#include "Parallel.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace bonedecimate
{
namespace
{
/// Versions in a window, of the faces of the input: more take memory, fewer take time.
constexpr double VersionsOfFaces = 1.3;
constexpr Index AllVersions = std::numeric_limits<Index>::max();
/// Faces at the time for each edit of a span: with more, spans are shorter, and what is found for several edits fits each better.
constexpr Index FacesOfASpan = 32;
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
  const std::vector<Index> edits = this->EditsToCheck(history);
  ForEachChunk(edits.size(), threads, {},
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Workspace work;
      for (std::size_t i = first; i < last; i += MostTogether)
      {
        const std::size_t count = std::min(MostTogether, last - i);
        for (std::size_t k = 0; k < count; ++k)
        {
          this->FillPatch(edits[i + k], work.Patches[k]);
        }
        this->CheckTogether(history, count, written, work);
      }
    });
}

//------------------------------------------------------------------------------
/// Those that follow each other are near in time, and then in space: faces lie along a curve that fills it.
std::vector<Index> EditReplay::EditsToCheck(const FaceHistory& history) const
{
  struct Where
  {
    Index Span;
    FaceId Face;
    Index Edit;
  };
  std::vector<Where> found;
  Index span = 0;
  Index left = 0; // edits of the span
  Index faces = history.NumberOfFaces();
  for (Index edit = history.FirstEdit(); edit < history.EndOfEdits(); ++edit)
  {
    if (left-- == 0)
    {
      ++span;
      left = faces / FacesOfASpan;
    }
    faces -= this->Journal.Entry(edit).IsUndone ? 0 : JournalEntry::NumberOfGoneFaces;
    if (this->States[edit] == State::Unchecked)
    {
      found.push_back({ span, this->Journal.OldFace(edit, 0).Face, edit });
    }
  }
  std::sort(found.begin(), found.end(),
    [](const Where& a, const Where& b)
    { return std::tie(a.Span, a.Face, a.Edit) < std::tie(b.Span, b.Face, b.Edit); });
  std::vector<Index> edits(found.size());
  std::transform(
    found.begin(), found.end(), edits.begin(), [](const Where& where) { return where.Edit; });
  return edits;
}

//------------------------------------------------------------------------------
/// The first patches of the workspace.
void EditReplay::CheckTogether(
  const FaceHistory& history, std::size_t count, const WrittenPositions& written, Workspace& work)
{
  FloatBox around;
  Index first = work.Patches[0].Edit;
  Index last = first;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Patch& patch = work.Patches[k];
    this->Boxes[patch.Edit] = BoxAround(patch.Old, patch.New, written.Rounding());
    around.Add(this->Boxes[patch.Edit]);
    first = std::min(first, patch.Edit);
    last = std::max(last, patch.Edit);
  }
  history.Find(around, first, last, work.Found);
  for (std::size_t k = 0; k < count; ++k)
  {
    Patch& patch = work.Patches[k];
    work.Near.clear();
    history.VisitAmong(work.Found, this->Boxes[patch.Edit], patch.Edit,
      [&](const FaceVersion& face)
      {
        work.Near.emplace_back(
          this->Mesh, this->Journal.VerticesOf(face), this->Journal.CornersOf(face));
      });
    const bool isRejected = MeetMore(patch.Old, patch.New, work.Near, written) ||
      JumpOver(patch.Old, patch.New, work.Near);
    this->States[patch.Edit] = isRejected ? State::Rejected : State::Accepted;
  }
}

//------------------------------------------------------------------------------
void EditReplay::FillPatch(Index edit, Patch& patch) const
{
  patch.Edit = edit;
  patch.Old.clear();
  patch.New.clear();
  const auto pieceOf = [this](const FaceVersion& face)
  { return Piece(this->Mesh, this->Journal.VerticesOf(face), this->Journal.CornersOf(face)); };
  for (Index i = 0; i < this->Journal.Entry(edit).NumberOfFaces; ++i)
  {
    patch.Old.push_back(pieceOf(this->Journal.OldFace(edit, i)));
    if (i >= JournalEntry::NumberOfGoneFaces)
    {
      patch.New.push_back(pieceOf(this->Journal.NewFace(edit, i)));
    }
  }
}
}
