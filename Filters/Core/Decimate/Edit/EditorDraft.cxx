// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What an Editor does to make a draft, to prove it and to undo parts of it.
#include "Draft.h"
#include "Editor.h"
#include "Proof/ErrorBound/BulkProof.h"
#include "Proof/ErrorBound/DraftFilter.h"
#include "Proof/Guard/Containment.h"
#include "Proof/Guard/IntersectionGuard.h"
#include "Proof/Guard/Separation.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace bonedecimate
{
namespace
{
/// How often the edits of a vertex are undone alone. Each later failure undoes one more of the last
/// edits around it.
constexpr int FailuresWithoutMore = 4;
constexpr int MaxFailures = 100; // later failures are not counted
/// After so many turns the draft is undone as a whole.
constexpr int MaxTurns = 120;
/// Ratio of the separation by which a draft may move points, so that two moving parts cannot meet.
constexpr double LessThanHalf = 0.49;
/// Distance within which other parts are searched, in largest errors: both may move by one, and a
/// hundredth is for rounding.
constexpr double ErrorsOfSeparation = 2.01;

/// Whether nothing has been edited.
bool IsAsAtFirst(const HalfEdgeMesh& first, const HalfEdgeMesh& now)
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

bool Editor::BeginDraft(int threads)
{
  const bool canDraft = this->DraftFound.Status == DraftStatus::NotUsed && !this->AfterEdit &&
    (!this->Guard || this->KnowsAround);
  if (!canDraft)
  {
    return false;
  }
  this->DraftFound.Status = DraftStatus::Used;
  const bool isFirst = IsAsAtFirst(this->BoundedMesh(), this->Half);
  this->Drafted = std::make_unique<Draft>(this->Half, this->LimitsOfDraft(isFirst, threads));
  if (this->Guard)
  {
    this->Drafted->State.emplace(this->Guard->CheckOf(*this->Drafted->Journal));
    this->Drafted->Enclosing =
      this->FindEnclosing(isFirst ? &this->BoundedTree(threads) : nullptr, threads);
  }
  this->Drafted->ExactFilters = this->Filters;
  this->Drafted->Rejections = this->RejectionCounts;
  this->Filters.clear();
  for (const std::shared_ptr<EditFilter>& filter : this->Drafted->ExactFilters)
  {
    if (filter == this->Bound)
    {
      const auto draftFilter = std::make_shared<DraftFilter>(
        *this->Bound, this->Drafted->Limits, this->Half, this->CurrentVertices(), threads);
      if (this->Guard && !isFirst)
      {
        draftFilter->KeepUnproved(this->Half, threads);
      }
      this->Filters.push_back(draftFilter);
    }
    else if (filter != this->Guard)
    {
      this->Filters.push_back(filter);
    }
  }
  this->Filters.push_back(this->Drafted->Journal);
  this->ForgetPending();
  return true;
}

//------------------------------------------------------------------------------
/// Where the mesh is not the original, what is near another part does not move at all: it may be
/// anywhere within the bound.
ErrorLimits Editor::LimitsOfDraft(bool isFirst, int threads) const
{
  ErrorLimits limits = this->Bound->Limits();
  if (this->Guard)
  {
    limits.Reduce(Separations(this->BoundedMesh(), ErrorsOfSeparation * limits.Most(), threads),
      isFirst ? LessThanHalf : 0.0);
  }
  return limits;
}

//------------------------------------------------------------------------------
/// What workspaces hold for the filters that there were.
void Editor::ForgetPending()
{
  this->Own.Pending.clear();
  this->ManifoldPatches.clear();
}

//------------------------------------------------------------------------------
bool Editor::EndDraft(int threads, const Monitor& monitor)
{
  this->Filters = this->Drafted->ExactFilters; // the filters of the draft need memory
  this->ForgetPending();
  BulkProof proof(
    *this->Bound, this->Drafted->Limits, this->Half, *this->Drafted->Journal, threads);
  for (int turn = 0; turn < MaxTurns; ++turn)
  {
    if (!monitor(static_cast<double>(turn) / MaxTurns))
    {
      this->UndoDraft(threads);
      return false;
    }
    const std::vector<Index> edits = this->FindRejectedEdits(proof, threads);
    if (edits.empty())
    {
      this->FinishDraft(threads);
      proof.WriteCoverage();
      return true;
    }
    this->Undo(edits);
  }
  this->DraftFound.Status = DraftStatus::Undone;
  this->UndoDraft(threads);
  return true;
}

//------------------------------------------------------------------------------
/// The cheaper checks first: there is less left to check then.
std::vector<Index> Editor::FindRejectedEdits(BulkProof& proof, int threads)
{
  const EditJournal& journal = *this->Drafted->Journal;
  std::vector<Index> edits = proof.FindFailures(this->CurrentVertices());
  if (edits.empty() && this->Drafted->State)
  {
    edits = this->Drafted->State->FindRejected(threads);
  }
  if (edits.empty())
  {
    const std::vector<char> isWrong = this->FindWrongComponents(threads);
    for (Index edit = 0; edit < journal.Count(); ++edit)
    {
      const JournalEntry& entry = journal.Entry(edit);
      if (!entry.IsUndone && isWrong[this->Fragments->ComponentOf(entry.Keep)] != 0)
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
std::vector<std::vector<Index>> Editor::FindEnclosing(const BoundingTree* tree, int threads) const
{
  return bonedecimate::FindEnclosing(
    this->Half, this->Fragments->Count(),
    [this](VertexId v) { return this->Fragments->ComponentOf(v); }, tree, threads);
}

//------------------------------------------------------------------------------
/// Marks components that became too small, or that are enclosed by other closed ones than before.
std::vector<char> Editor::FindWrongComponents(int threads) const
{
  std::vector<char> isWrong = this->Fragments->FindTooSmall(this->Half);
  if (this->Guard)
  {
    const std::vector<std::vector<Index>>& before = this->Drafted->Enclosing;
    const std::vector<std::vector<Index>> now = this->FindEnclosing(nullptr, threads);
    for (std::size_t i = 0; i < now.size(); ++i)
    {
      std::vector<Index> changed;
      std::set_symmetric_difference(before[i].begin(), before[i].end(), now[i].begin(),
        now[i].end(), std::back_inserter(changed));
      for (const Index other : changed)
      {
        if (this->Fragments->IsClosed(other))
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
void Editor::Undo(const std::vector<Index>& edits)
{
  const EditJournal& journal = *this->Drafted->Journal;
  for (const Index edit : edits)
  {
    const JournalEntry& entry = journal.Entry(edit);
    this->UndoWithDependents(edit);
    int failures = 0;
    for (const VertexId v : { entry.Keep, entry.Gone })
    {
      std::uint8_t& count = this->Drafted->Failures[v];
      count = static_cast<std::uint8_t>(std::min(MaxFailures, count + 1));
      failures = std::max<int>(failures, count);
    }
    for (int more = FailuresWithoutMore; more < failures; ++more)
    {
      Index last = None;
      for (Index i = 0; i < entry.NumberOfFaces; ++i)
      {
        last = std::max(last, journal.LastOfFace(journal.OldFace(edit, i).Face));
      }
      if (last != None)
      {
        this->UndoWithDependents(last);
      }
    }
  }
}

//------------------------------------------------------------------------------
void Editor::UndoWithDependents(Index edit)
{
  if (!this->Drafted->Journal->Entry(edit).IsUndone)
  {
    for (const Index dependent : this->Drafted->Journal->DependentsOf(edit))
    {
      this->UndoOne(dependent);
    }
  }
}

//------------------------------------------------------------------------------
/// Nothing that is left depends on it.
void Editor::UndoOne(Index edit)
{
  EditJournal& journal = *this->Drafted->Journal;
  const JournalEntry& entry = journal.Entry(edit);
  for (Index i = 0; i < entry.NumberOfFaces; ++i)
  {
    const FaceVersion& face = journal.OldFace(edit, i);
    this->Half.RestoreCorners(face.Face, journal.VerticesOf(face));
    if (face.Made == None && !journal.HadFirstNormal(face.Face))
    {
      this->Half.ForgetFirstNormal(face.Face);
    }
  }
  this->Half.RestoreOutgoing(entry.Keep, entry.Outgoing[0]);
  this->Half.RestoreOutgoing(entry.Gone, entry.Outgoing[1]);
  for (Index i = 0; i < JournalEntry::NumberOfGoneFaces; ++i)
  {
    const FaceVersion& face = journal.OldFace(edit, i);
    const auto side = static_cast<std::size_t>(i);
    this->Half.RestoreTwins(face.Face, entry.Twins[side]);
    for (const VertexId v : journal.VerticesOf(face))
    {
      if (v != entry.Keep && v != entry.Gone)
      {
        this->Half.RestoreOutgoing(v, entry.Outgoing[2 + side]);
      }
    }
  }
  this->Half.Move(entry.Keep, journal.OldPosition(entry));
  this->Half.CountRemovedFaces(-JournalEntry::NumberOfGoneFaces);
  this->Source.Unmerge(entry.Gone);
  --this->Edits;
  journal.Remove(edit);
}

//------------------------------------------------------------------------------
void Editor::UndoDraft(int threads)
{
  for (Index edit = this->Drafted->Journal->Count(); edit-- > 0;)
  {
    this->UndoWithDependents(edit);
  }
  this->FinishDraft(threads);
}

//------------------------------------------------------------------------------
void Editor::FinishDraft(int threads)
{
  const EditJournal& journal = *this->Drafted->Journal;
  this->DraftFound.Collapses = journal.Count();
  this->DraftFound.Undone = journal.NumberOfUndone();
  if (this->Guard)
  {
    this->Guard->TakeDraft(journal);
  }
  this->Filters = this->Drafted->ExactFilters;
  this->RejectionCounts = this->Drafted->Rejections;
  this->Drafted.reset();
  this->ForgetPending();
  this->RenewQuadrics(threads);
  this->DistributeVolumeBudget();
}
}
