// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Editor.h"

#include "Gate.h"
#include "Geometry/TriangleGeometry.h"
#include "Mesh/Sheets.h"
#include "Parallel.h"
#include "RingQuadrics.h"
#include "SheetRules.h"
#include "SmallEdits.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
Verdict Count(Verdict verdict, Workspace& work)
{
  if (verdict != Verdict::Allowed && verdict != Verdict::Elsewhere)
  {
    ++work.Counted.Refusals[static_cast<std::size_t>(verdict)];
  }
  return verdict;
}
}

Editor::Editor(const CleanSurface& clean, const Books& books, int threads)
  : Editor(HalfEdgeMesh(clean.Surface, threads, clean.Sheets), clean, books, threads)
{
}

//------------------------------------------------------------------------------
Editor::Editor(HalfEdgeMesh mesh, const CleanSurface& clean, const Books& books, int threads)
  : Half(std::move(mesh))
  , KeepsQuadrics(books.Quadrics)
  , Source(clean, books.Distances)
  , Volumes(
      WithJoined(clean, [this](const Surface& joined) { return Fragments(this->Half, joined); }))
{
  if (books.Areas)
  {
    this->FaceGeometry.emplace(this->Half);
  }
  if (books.Quadrics)
  {
    SumRingQuadrics(this->Half, threads);
  }
}

//------------------------------------------------------------------------------
const HalfEdgeMesh& Editor::KeepFirst()
{
  if (!this->First)
  {
    this->First = std::make_unique<HalfEdgeMesh>(this->Half);
  }
  return *this->First;
}

//------------------------------------------------------------------------------
void Editor::ProveEdits(const Promise& promise, int threads)
{
  this->Guard = std::make_unique<Guarantee>(this->KeepFirst(), this->Source.Tree(threads), promise);
}

//------------------------------------------------------------------------------
Index Editor::Freeze(const std::vector<double>& tolerances)
{
  const auto isFrozen = [&](Index v)
  { return this->Guard ? !(this->Guard->LimitAt(v) > 0.0) : tolerances[v] == 0.0; };
  for (Index face = 0; face < this->Half.NumberOfFaceSlots(); ++face)
  {
    const Triangle corners = this->Half.Corners(face);
    if (std::any_of(corners.begin(), corners.end(), isFrozen))
    {
      std::for_each(corners.begin(), corners.end(), [this](Index v) { this->Half.Freeze(v); });
    }
  }
  Index count = 0;
  for (Index v = 0; v < this->Half.NumberOfVertexSlots(); ++v)
  {
    count += isFrozen(v) && this->Half.Site(v) == v ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
void Editor::KeepClearance(double error, int threads, const Monitor& monitor)
{
  this->Clearance = WithJoined(this->Source.AtFirst(),
    [&](const Surface& joined)
    { return std::make_unique<ClearanceGuard>(this->Half, joined, error, threads, monitor); });
}

//------------------------------------------------------------------------------
template <typename Fill>
Verdict Editor::Prove(Workspace& work, const Fill& fill) const
{
  if (!this->Guard)
  {
    return Verdict::Allowed;
  }
  if (!work.Proofs)
  {
    work.Proofs = this->Guard->Lend();
  }
  fill(work.Proofs->Change);
  const Patch& change = work.Proofs->Change;
  if (this->Clearance && !this->Clearance->Owns(this->Half, change, work.Range, work.Nearby))
  {
    return Verdict::Elsewhere;
  }
  const ProofAnswer answer = work.Proofs->Prove(this->Half, work.Range);
  if (answer == ProofAnswer::Proved && this->Clearance)
  {
    return this->Clearance->Judge(this->Half, change, work.Nearby);
  }
  return answer == ProofAnswer::Proved ? Verdict::Allowed
    : answer == ProofAnswer::Refused   ? Verdict::TooFar
                                       : Verdict::Elsewhere;
}

//------------------------------------------------------------------------------
/// Of the edit that was proved last and has been carried out.
void Editor::CommitProof(Workspace& work)
{
  if (this->Guard)
  {
    work.Proofs->Commit();
  }
  if (this->Clearance)
  {
    this->Clearance->Commit(this->Half, work.Proofs->Change, work.Nearby);
  }
}

//------------------------------------------------------------------------------
Verdict Editor::JudgeEdge(Index edge, Workspace& work) const
{
  const Verdict ends = JudgeEnds(this->Half, edge);
  if (ends != Verdict::Allowed)
  {
    return ends;
  }
  work.Around.Gather(this->Half, edge);
  Verdict topology = JudgeTopology(this->Half, work.Around);
  if (topology == Verdict::Allowed && this->Half.HasSheets())
  {
    topology = JudgeSheets(this->Half, work.Around, work.Range);
  }
  if (topology != Verdict::Allowed)
  {
    work.Around.Edge = None;
    return topology;
  }
  FillFan(
    this->Half, work.Around, work.Faces.Reserve(static_cast<int>(work.Around.Corners.size())));
  return Verdict::Allowed;
}

//------------------------------------------------------------------------------
Verdict Editor::Examine(Index edge)
{
  const Verdict verdict = this->Examine(edge, this->Own);
  this->Settle(this->Own.Counted);
  return verdict;
}

//------------------------------------------------------------------------------
Verdict Editor::Examine(Index edge, Workspace& work) const
{
  return Count(this->JudgeEdge(edge, work), work);
}

//------------------------------------------------------------------------------
Verdict Editor::Apply(const Edit& edit)
{
  const Verdict verdict = this->Apply(edit, this->Own, 1);
  this->Settle(this->Own.Counted);
  return verdict;
}

//------------------------------------------------------------------------------
Verdict Editor::Apply(const Edit& wanted, Workspace& work, int workers)
{
  Edit edit = wanted;
  if (this->Guard && !edit.KeepStays)
  {
    edit.Position = this->Guard->Rounded(edit.Position);
  }
  if (work.Around.Edge != edit.Edge)
  {
    const Verdict verdict = this->Examine(edit.Edge, work);
    if (verdict != Verdict::Allowed)
    {
      return verdict;
    }
  }
  double volumeChange = 0.0; // mm^3
  const Verdict verdict =
    JudgePlace(this->Half, work.Around, edit, work.Faces.Current(), volumeChange);
  if (verdict != Verdict::Allowed)
  {
    return Count(verdict, work);
  }
  if (!this->Volumes.MayChange(edit.Keep, volumeChange, work.Counted.Volumes, workers))
  {
    return Count(Verdict::Fragment, work);
  }
  const Verdict proof =
    this->Prove(work, [&](Patch& change) { change.FillCollapse(this->Half, work.Around, edit); });
  if (proof != Verdict::Allowed)
  {
    return Count(proof, work);
  }
  const Index gone = this->Half.Across(edit.Edge, edit.Keep);
  const Vector3 origin = this->Half.Position(work.Around.Start);
  const Fan& fan = work.Faces.Current();
  for (std::size_t i = 0; i < work.Around.Corners.size(); ++i)
  {
    this->Half.KeepFirstNormal(HalfEdgeMesh::Face(work.Around.Corners[i]),
      { fan.OldArea[0][i], fan.OldArea[1][i], fan.OldArea[2][i] });
  }
  this->Half.Collapse(work.Around, edit.Keep, edit.Position);
  this->CommitProof(work);
  if (this->KeepsQuadrics)
  {
    ExchangeRingQuadrics(this->Half, work.Around, edit.Keep, origin, work.Faces.Current());
  }
  this->KeepBooks(edit, gone, volumeChange, work);
  return Verdict::Allowed;
}

//------------------------------------------------------------------------------
void Editor::KeepFirstNormal(Index face)
{
  const Triangle c = this->Half.Corners(face);
  this->Half.KeepFirstNormal(face,
    AreaVector(this->Half.Position(c[0]), this->Half.Position(c[1]), this->Half.Position(c[2])));
}

//------------------------------------------------------------------------------
Verdict Editor::ApplySmall(const Edit& wanted, Workspace& work, int workers)
{
  Edit edit = wanted;
  const bool flips = edit.Kind == EditKind::Flip;
  if (this->Guard && !flips)
  {
    edit.Position = this->Guard->Rounded(edit.Position);
  }
  const Index vertex = flips ? this->Half.Origin(edit.Edge) : edit.Keep;
  double volumeChange = 0.0; // mm^3
  Verdict verdict = flips ? JudgeFlip(this->Half, edit.Edge, volumeChange)
                          : JudgeMove(this->Half, vertex, edit.Position, volumeChange);
  if (verdict == Verdict::Allowed && flips && this->Half.HasSheets())
  {
    const std::array<Index, 4> corners = CornersAround(this->Half, edit.Edge);
    verdict = JudgeNewEdge(this->Half, corners[2], corners[3], work.Range);
  }
  if (verdict != Verdict::Allowed)
  {
    return verdict;
  }
  const bool needsShare = !this->Volumes.ShareAllows(vertex, volumeChange);
  if (needsShare &&
    !this->Volumes.MayChange(vertex, volumeChange, work.Counted.Volumes, 2 * workers))
  {
    return Verdict::Fragment;
  }
  const Verdict proof = this->Prove(work,
    [&](Patch& change)
    { flips ? change.FillFlip(this->Half, edit) : change.FillMove(this->Half, edit); });
  if (proof != Verdict::Allowed)
  {
    return proof;
  }
  if (needsShare)
  {
    work.Counted.Volumes.Add(this->Volumes.ComponentOf(vertex), volumeChange);
  }
  if (flips)
  {
    this->KeepFirstNormal(HalfEdgeMesh::Face(edit.Edge));
    this->KeepFirstNormal(HalfEdgeMesh::Face(this->Half.Twin(edit.Edge)));
    this->Half.Flip(edit.Edge);
  }
  else
  {
    for (const Index h : this->Half.OutgoingOf(vertex))
    {
      this->KeepFirstNormal(HalfEdgeMesh::Face(h));
    }
    this->Half.Move(vertex, edit.Position);
  }
  this->CommitProof(work);
  if (this->AfterEdit)
  {
    this->AfterEdit(*this, edit);
  }
  return Verdict::Allowed;
}

//------------------------------------------------------------------------------
void Editor::KeepBooks(const Edit& edit, Index gone, double volumeChange, Workspace& work)
{
  if (this->FaceGeometry)
  {
    for (const Index h : work.Around.Corners)
    {
      this->FaceGeometry->Update(this->Half, HalfEdgeMesh::Face(h));
    }
  }
  this->Source.Merge(edit.Keep, gone, edit.Position);
  work.Counted.Volumes.Add(this->Volumes.ComponentOf(edit.Keep), volumeChange);
  work.Counted.RemovedFaces += work.Around.NumberOfGoneFaces;
  if (this->Recorder)
  {
    work.Counted.Log.push_back(
      { edit.Position, edit.Edge, work.Around.GoneFaces[1], edit.Keep, work.Rank });
  }
  work.Around.Edge = None;
  ++work.Counted.Edits;
  if (this->AfterEdit)
  {
    this->Settle(work.Counted);
    this->AfterEdit(*this, edit);
  }
}

//------------------------------------------------------------------------------
void Editor::Settle(Tally& tally)
{
  this->Volumes.Settle(tally.Volumes);
  this->Half.CountRemovedFaces(tally.RemovedFaces);
  this->Edits += tally.Edits;
  for (std::size_t i = 0; i < NumberOfVerdicts; ++i)
  {
    this->RefusalsByVerdict[i] += tally.Refusals[i];
  }
  tally.Refusals.fill(0); // the list of volumes keeps its memory
  tally.Edits = 0;
  tally.RemovedFaces = 0;
  if (this->Recorder)
  {
    this->Recorder->Add(tally.Log);
  }
}

//------------------------------------------------------------------------------
void Editor::Settle(std::vector<Tally>& tallies)
{
  if (this->Recorder)
  {
    std::vector<std::vector<LoggedCollapse>*> lists;
    lists.reserve(tallies.size());
    for (Tally& tally : tallies)
    {
      lists.push_back(&tally.Log);
    }
    this->Recorder->AddMerged(lists);
  }
  for (Tally& tally : tallies)
  {
    this->Settle(tally);
  }
}

//------------------------------------------------------------------------------
void Editor::BeginSmallEdits()
{
  if (this->Recorder)
  {
    this->Recorder->BeginPatch(this->Half);
  }
}

//------------------------------------------------------------------------------
void Editor::EndSmallEdits()
{
  if (this->Recorder)
  {
    this->Recorder->EndPatch(this->Half);
  }
}
}
