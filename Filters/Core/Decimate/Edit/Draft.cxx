// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Draft.h"
#include "Proof/ErrorBound/BulkProof.h"
#include "Proof/ErrorBound/DraftFilter.h"
#include "Proof/Guard/Containment.h"
#include "Proof/Guard/IntersectionGuard.h"
#include "Proof/Guard/Separation.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Number of failures of a vertex after which only the rejected edits are undone. Each later
/// failure also undoes one more of the last edits around it.
constexpr int FailuresWithoutMore = 4;
constexpr int MaxFailures = 100; // later failures are not counted
/// Number of turns after which the whole draft is undone.
constexpr int MaxTurns = 120;
/// Fraction of the separation by which a draft may move points, so that two moving parts cannot
/// meet.
constexpr double LessThanHalf = 0.49;
/// Distance within which other parts are searched, in largest errors: both parts may move by one; a
/// hundredth is for rounding.
constexpr double ErrorsOfSeparation = 2.01;

/// Whether the mesh has not been edited.
bool IsUnedited(const HalfEdgeMesh& first, const HalfEdgeMesh& now)
{
  bool isSame = first.NumberOfFaceSlots() == now.NumberOfFaceSlots();
  for (FaceId face = 0; isSame && face < first.NumberOfFaceSlots(); ++face)
  {
    isSame = first.IsAlive(face) == now.IsAlive(face) &&
      (!now.IsAlive(face) ||
        (first.Corners(face) == now.Corners(face) &&
          PositionsOf(first, face) == PositionsOf(now, face)));
  }
  return isSame;
}
}

Draft::Draft(Editor& editor, int threads)
  : MeshEditor(editor)
  , Threads(threads)
  , StartsFromOriginal(IsUnedited(editor.OriginalSurface.BoundedMesh(), editor.CurrentMesh))
  , Journal(std::make_shared<EditJournal>(editor.CurrentMesh))
  , Limits(editor.BoundFilter->Limits())
  , Failures(static_cast<std::size_t>(editor.CurrentMesh.NumberOfVertexSlots()), 0)
  , ExactFilters(editor.Filters)
  , Rejections(editor.Total.Rejections)
{
  editor.Total.Draft.Status = DraftStatus::Used;
}

//------------------------------------------------------------------------------
bool Draft::Begin(const Monitor& monitor)
{
  const bool isGuarded = this->MeshEditor.Guard != nullptr;
  const bool begins = (!isGuarded || (this->ReduceLimits(monitor) && this->NoteState(monitor))) &&
    this->ExchangeFilters(monitor);
  if (!begins)
  {
    this->Undo();
  }
  return begins;
}

//------------------------------------------------------------------------------
/// If the mesh is not the original, nothing near another part may move, because the mesh may be
/// anywhere within the bound. False if the monitor requests a stop, as below.
bool Draft::ReduceLimits(const Monitor& monitor)
{
  const auto separations = FindSeparations(this->MeshEditor.OriginalSurface.BoundedMesh(),
    ErrorsOfSeparation * this->Limits.Max(), this->Threads, monitor);
  if (separations)
  {
    this->Limits.Reduce(*separations, this->StartsFromOriginal ? LessThanHalf : 0.0);
  }
  return separations.has_value();
}

//------------------------------------------------------------------------------
/// What the guard compares with afterwards.
bool Draft::NoteState(const Monitor& monitor)
{
  Editor& editor = this->MeshEditor;
  this->State.emplace(editor.Guard->MakeStateCheck(*this->Journal));
  this->Enclosing = this->FindEnclosing(
    this->StartsFromOriginal ? &editor.OriginalSurface.BoundedTree(this->Threads) : nullptr);
  return monitor(0.0);
}

//------------------------------------------------------------------------------
bool Draft::ExchangeFilters(const Monitor& monitor)
{
  bool shouldContinue = true;
  Editor& editor = this->MeshEditor;
  editor.Filters.clear();
  for (const std::shared_ptr<EditFilter>& filter : this->ExactFilters)
  {
    if (filter == editor.BoundFilter)
    {
      const auto draftFilter = std::make_shared<DraftFilter>(*editor.BoundFilter, this->Limits,
        editor.CurrentMesh, editor.OriginalSurface.CurrentOfInitial(), this->Threads);
      if (editor.Guard && !this->StartsFromOriginal)
      {
        shouldContinue = draftFilter->KeepUnproved(editor.CurrentMesh, this->Threads, monitor);
      }
      editor.Filters.push_back(draftFilter);
    }
    else if (filter != editor.Guard)
    {
      editor.Filters.push_back(filter);
    }
  }
  editor.Filters.push_back(this->Journal);
  editor.PatchWorkspaces.clear(); // they hold data of the previous filters
  return shouldContinue;
}

//------------------------------------------------------------------------------
bool Draft::Prove(const Monitor& monitor)
{
  Editor& editor = this->MeshEditor;
  editor.Filters = this->ExactFilters; // frees the memory of the draft's filters
  editor.PatchWorkspaces.clear();
  BulkProof proof(
    *editor.BoundFilter, this->Limits, editor.CurrentMesh, *this->Journal, this->Threads);
  for (int turn = 0; turn < MaxTurns; ++turn)
  {
    const auto whole = [&](double) { return monitor(static_cast<double>(turn) / MaxTurns); };
    const std::optional<std::vector<Index>> edits = this->FindRejectedEdits(proof, whole);
    if (!edits)
    {
      this->Undo();
      return false;
    }
    if (edits->empty())
    {
      this->Finish();
      proof.WriteCoverage();
      return true;
    }
    this->UndoRejected(*edits);
  }
  editor.Total.Draft.Status = DraftStatus::Undone;
  this->Undo();
  return true;
}

//------------------------------------------------------------------------------
/// Runs the cheaper checks first, so that less is left to check. Nothing if the monitor requests a
/// stop.
std::optional<std::vector<Index>> Draft::FindRejectedEdits(BulkProof& proof, const Monitor& monitor)
{
  std::optional<std::vector<Index>> failures =
    proof.FindFailures(this->MeshEditor.OriginalSurface.CurrentOfInitial(), monitor);
  if (!failures || !monitor(0.0))
  {
    return std::nullopt;
  }
  std::vector<Index> edits = std::move(*failures);
  if (edits.empty() && this->State)
  {
    edits = this->State->FindEditsToUndo(this->Threads);
  }
  if (edits.empty())
  {
    const std::vector<char> isWrong = this->FindWrongComponents();
    for (Index edit = 0; edit < this->Journal->Count(); ++edit)
    {
      const JournalEntry& entry = this->Journal->Entry(edit);
      if (!entry.IsUndone && isWrong[this->MeshEditor.Fragments->ComponentOf(entry.Keep)] != 0)
      {
        edits.push_back(edit);
      }
    }
  }
  std::sort(edits.begin(), edits.end(), std::greater<>());
  edits.erase(std::unique(edits.begin(), edits.end()), edits.end());
  return edits;
}

//------------------------------------------------------------------------------
std::vector<std::vector<Index>> Draft::FindEnclosing(const BoundingTree* tree) const
{
  return bonedecimate::FindEnclosing(
    this->MeshEditor.CurrentMesh, this->MeshEditor.Fragments->Count(),
    [this](VertexId v) { return this->MeshEditor.Fragments->ComponentOf(v); }, tree, this->Threads);
}

//------------------------------------------------------------------------------
/// Marks components that became too small, or that are enclosed by other closed ones than before.
std::vector<char> Draft::FindWrongComponents() const
{
  const FragmentGuard& fragments = *this->MeshEditor.Fragments;
  std::vector<char> isWrong = fragments.FindTooSmall(this->MeshEditor.CurrentMesh);
  if (this->MeshEditor.Guard)
  {
    const std::vector<std::vector<Index>>& before = this->Enclosing;
    const std::vector<std::vector<Index>> now = this->FindEnclosing(nullptr);
    for (std::size_t i = 0; i < now.size(); ++i)
    {
      std::vector<Index> changed;
      std::set_symmetric_difference(before[i].begin(), before[i].end(), now[i].begin(),
        now[i].end(), std::back_inserter(changed));
      for (const Index other : changed)
      {
        if (fragments.IsClosed(other))
        {
          isWrong[i] = 1;
          isWrong[other] = 1;
        }
      }
    }
  }
  return isWrong;
}

//------------------------------------------------------------------------------
void Draft::UndoRejected(const std::vector<Index>& edits)
{
  const EditJournal& journal = *this->Journal;
  for (const Index edit : edits)
  {
    const JournalEntry& entry = journal.Entry(edit);
    this->UndoWithDependents(edit);
    int failures = 0;
    for (const VertexId v : { entry.Keep, entry.Gone })
    {
      std::uint8_t& count = this->Failures[v];
      count = static_cast<std::uint8_t>(std::min(MaxFailures, count + 1));
      failures = std::max<int>(failures, count);
    }
    for (int more = FailuresWithoutMore; more < failures; ++more)
    {
      Index last = None;
      for (Index i = 0; i < entry.NumberOfFaces; ++i)
      {
        last = std::max(last, journal.LastEditOf(journal.OldFace(edit, i).Face));
      }
      if (last != None)
      {
        this->UndoWithDependents(last);
      }
    }
  }
}

//------------------------------------------------------------------------------
void Draft::UndoWithDependents(Index edit)
{
  if (!this->Journal->Entry(edit).IsUndone)
  {
    for (const Index dependent : this->Journal->DependentsOf(edit))
    {
      this->MeshEditor.Undo(*this->Journal, dependent);
    }
  }
}

//------------------------------------------------------------------------------
void Draft::Undo()
{
  for (Index edit = this->Journal->Count(); edit-- > 0;)
  {
    this->UndoWithDependents(edit);
  }
  this->Finish();
}

//------------------------------------------------------------------------------
void Draft::Finish()
{
  Editor& editor = this->MeshEditor;
  editor.Total.Draft.Collapses = this->Journal->Count();
  editor.Total.Draft.Undone = this->Journal->NumberOfUndone();
  if (editor.Guard)
  {
    editor.Guard->TakeDraft(*this->Journal);
  }
  editor.Filters = this->ExactFilters;
  editor.Total.Rejections = this->Rejections;
  editor.PatchWorkspaces.clear();
  this->State.reset(); // frees memory for what follows
  this->Journal.reset();
  this->Enclosing = {};
  this->Failures = {};
  editor.PrepareCollapses(this->Threads);
}
}
