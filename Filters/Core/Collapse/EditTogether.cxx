// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What an Editor does with an edge of a seam, which is one edge in several sheets.
#include "Editor.h"
#include "Gate.h"
#include "RingQuadrics.h"
#include "SheetRules.h"

#include <algorithm>

namespace bonedecimate
{
SeamLines* Editor::Lines()
{
  return this->Seams && this->Seams->NumberOfEdges() > 0 ? this->Seams.get() : nullptr;
}

//------------------------------------------------------------------------------
/// Nothing is changed before all sheets allow it. Their faces have no corner in common that moves or goes, so that each may
/// be judged as if it were alone.
Verdict Editor::JudgeTogether(const std::vector<Edit>& edits)
{
  std::vector<const Neighbourhood*> around;
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    Workspace& work = this->Sheets[i].Space;
    work.Around.Gather(this->Half, edits[i].Edge);
    const Verdict topology = JudgeTopology(this->Half, work.Around);
    if (topology != Verdict::Allowed)
    {
      return topology;
    }
    around.push_back(&work.Around);
  }
  const Index gone = this->Half.Across(edits[0].Edge, edits[0].Keep);
  Verdict verdict = JudgeSeam(this->Half, around, this->Half.Site(gone));
  for (std::size_t i = 0; i < edits.size() && verdict == Verdict::Allowed; ++i)
  {
    SheetEdit& sheet = this->Sheets[i];
    Workspace& work = sheet.Space;
    FillFan(
      this->Half, work.Around, work.Faces.Reserve(static_cast<int>(work.Around.Corners.size())));
    verdict =
      JudgePlace(this->Half, work.Around, edits[i], work.Faces.Current(), sheet.VolumeChange);
    sheet.Origin = this->Half.Position(work.Around.Start);
  }
  return verdict;
}

//------------------------------------------------------------------------------
/// As one patch, which is judged with the first workspace.
Verdict Editor::ProveTogether(const std::vector<Edit>& edits)
{
  Workspace& first = this->Sheets[0].Space;
  Patch& change = this->PatchOf(first);
  change.FillCollapse(this->Half, first.Around, edits[0]);
  for (std::size_t i = 1; i < edits.size(); ++i)
  {
    change.AddCollapse(this->Half, this->Sheets[i].Space.Around, edits[i]);
  }
  return this->ProvePatch(first);
}

//------------------------------------------------------------------------------
/// A collapse that was judged last with this workspace.
void Editor::CarryOut(const Edit& edit, Workspace& work)
{
  const Fan& fan = work.Faces.Current();
  for (std::size_t i = 0; i < work.Around.Corners.size(); ++i)
  {
    this->Half.KeepFirstNormal(HalfEdgeMesh::Face(work.Around.Corners[i]),
      { fan.OldArea[0][i], fan.OldArea[1][i], fan.OldArea[2][i] });
  }
  this->Half.Collapse(work.Around, edit.Keep, edit.Position);
}

//------------------------------------------------------------------------------
Verdict Editor::ApplyTogether(const std::vector<Edit>& edits)
{
  if (this->Sheets.size() < edits.size())
  {
    this->Sheets.resize(edits.size());
  }
  Verdict verdict = this->JudgeTogether(edits);
  if (verdict == Verdict::Allowed && this->Guard)
  {
    verdict = this->ProveTogether(edits);
  }
  if (verdict != Verdict::Allowed)
  {
    ++this->RefusalsByVerdict[static_cast<std::size_t>(verdict)];
    return verdict;
  }
  std::vector<Index> gone;
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    gone.push_back(this->Half.Across(edits[i].Edge, edits[i].Keep));
    this->CarryOut(edits[i], this->Sheets[i].Space);
  }
  this->CommitProof(this->Sheets[0].Space);
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    SheetEdit& sheet = this->Sheets[i];
    if (this->KeepsQuadrics)
    {
      ExchangeRingQuadrics(
        this->Half, sheet.Space.Around, edits[i].Keep, sheet.Origin, sheet.Space.Faces.Current());
    }
    this->KeepBooks(edits[i], gone[i], sheet.VolumeChange, sheet.Space);
    this->Settle(sheet.Space.Counted);
  }
  this->Edits -= static_cast<std::int64_t>(edits.size()) - 1; // one point went
  return Verdict::Allowed;
}
}
