// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// An edit is applied only if every filter accepts it, and only then do filters commit.
#include "BruteForce.h"
#include "Decimate/Edit/Editor.h"
#include "EditAlone.h"
#include "Mesh/Invariants.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Gives the decisions it is told and lists its calls.
class ScriptedFilter : public EditFilter
{
public:
  ScriptedFilter(std::string name, std::vector<std::string>& calls)
    : Name(std::move(name))
    , Calls(calls)
  {
  }

  bool NeedsSurfaceChange() const override { return this->ReadsChange; }
  Decision Screen(const HalfEdgeMesh& mesh, const SurfaceChange&, Pending&) const override
  {
    this->FacesAtScreen = mesh.NumberOfFaces();
    return this->Record("screen", this->OfScreen);
  }
  Decision Check(const HalfEdgeMesh&, const SurfaceChange& change, Pending&) const override
  {
    this->ChangedFaces = change.NewFaces.size();
    return this->Record("check", this->OfCheck);
  }
  void Commit(const HalfEdgeMesh&, const SurfaceChange& change, Pending&, Tally&) override
  {
    this->Calls.push_back(this->Name + " commit");
    this->Committed.push_back(change.Requested.Kind);
  }
  void Settle(Tally*, std::size_t count) override { this->Settled += count; }

  Decision OfScreen = Decision::Accept();
  Decision OfCheck = Decision::Accept();
  bool ReadsChange = false;
  std::vector<EditKind> Committed;
  std::size_t Settled = 0;
  mutable Index FacesAtScreen = 0;
  mutable std::size_t ChangedFaces = 0;

private:
  Decision Record(const std::string& call, Decision decision) const
  {
    this->Calls.push_back(this->Name + " " + call);
    return decision;
  }

  std::string Name;
  std::vector<std::string>& Calls;
};

/// A sphere and an editor with two filters.
class EditFilters : public testing::Test
{
protected:
  EditFilters()
    : Cleaned(Clean(Icosphere(2, 10.0), true))
  {
    EditorSettings settings{ false, false, false };
    settings.MoreFilters = { this->First, this->Second };
    this->MeshEditor.emplace(this->Cleaned, settings);
    this->MeshEditor->PrepareCollapses(1);
  }

  Decision Collapse()
  {
    const HalfEdgeMesh& mesh = this->MeshEditor->Mesh();
    return TryAlone(*this->MeshEditor, { 0, mesh.Origin(0), this->Middle() });
  }
  Vector3 Middle() const
  {
    const HalfEdgeMesh& mesh = this->MeshEditor->Mesh();
    return 0.5 * (mesh.Position(mesh.Origin(0)) + mesh.Position(mesh.Target(0)));
  }
  std::int64_t Rejections() const
  {
    std::int64_t sum = 0;
    for (const std::int64_t count : this->MeshEditor->Totals().Rejections)
    {
      sum += count;
    }
    return sum;
  }
  void ExpectUnchanged() const
  {
    EXPECT_TRUE(SameBytes(SurfaceOf(this->MeshEditor->Mesh()), this->Cleaned.Surface));
    EXPECT_EQ(this->MeshEditor->Totals().Collapses, 0);
    EXPECT_TRUE(this->First->Committed.empty());
    EXPECT_TRUE(this->Second->Committed.empty());
  }

  std::vector<std::string> Calls;
  std::shared_ptr<ScriptedFilter> First = std::make_shared<ScriptedFilter>("first", this->Calls);
  std::shared_ptr<ScriptedFilter> Second = std::make_shared<ScriptedFilter>("second", this->Calls);
  CleanSurface Cleaned;
  std::optional<Editor> MeshEditor;
};
}

TEST_F(EditFilters, ScreenBeforeAnyChecksAndCommitWhenAllAccept)
{
  EXPECT_TRUE(this->Collapse().IsAccepted());
  EXPECT_EQ(this->Calls,
    (std::vector<std::string>{ "first screen", "second screen", "first check", "second check",
      "first commit", "second commit" }));
  EXPECT_EQ(this->MeshEditor->Totals().Collapses, 1);
  EXPECT_EQ(this->Rejections(), 0);
  EXPECT_EQ(this->First->FacesAtScreen, this->MeshEditor->Mesh().NumberOfFaceSlots());
  EXPECT_GE(this->First->Settled, 1U);
  EXPECT_EQ(BrokenInvariant(this->MeshEditor->Mesh()), "");
}

TEST_F(EditFilters, RejectForTheFirstReasonFoundAndNothingIsCommitted)
{
  this->Second->OfCheck = Rejection::Intersection;
  EXPECT_EQ(this->Collapse(), Rejection::Intersection);
  EXPECT_EQ(this->Calls.back(), "second check");
  this->ExpectUnchanged();
  this->First->OfCheck = Rejection::ErrorBound;
  EXPECT_EQ(this->Collapse(), Rejection::ErrorBound);
  EXPECT_EQ(this->Calls.back(), "first check");
  this->Second->OfScreen = Rejection::Fragment;
  EXPECT_EQ(this->Collapse(), Rejection::Fragment) << "screens come before checks";
  EXPECT_EQ(this->Calls.back(), "second screen");
  this->ExpectUnchanged();
  EXPECT_EQ(this->Rejections(), 3);
  for (const Rejection reason :
    { Rejection::Intersection, Rejection::ErrorBound, Rejection::Fragment })
  {
    EXPECT_EQ(this->MeshEditor->Totals().Rejections[static_cast<std::size_t>(reason)], 1);
  }
}

TEST_F(EditFilters, DeferAnEditWithoutARejection)
{
  this->First->OfScreen = Decision::Defer();
  const Decision screened = this->Collapse();
  EXPECT_TRUE(screened.IsDeferred());
  EXPECT_FALSE(screened.IsAccepted());
  EXPECT_FALSE(screened.IsRejected());
  EXPECT_EQ(this->Calls, std::vector<std::string>{ "first screen" });
  this->First->OfScreen = Decision::Accept();
  this->Second->OfCheck = Decision::Defer();
  EXPECT_TRUE(this->Collapse().IsDeferred());
  this->ExpectUnchanged();
  EXPECT_EQ(this->Rejections(), 0);
  this->Second->OfCheck = Decision::Accept();
  EXPECT_TRUE(this->Collapse().IsAccepted()) << "it may be proposed again";
}

TEST_F(EditFilters, AreNotRunOnWhatTheRulesReject)
{
  EXPECT_TRUE(
    TryAlone(*this->MeshEditor, { 0, this->MeshEditor->Mesh().Origin(0), { 999, 999, 999 } })
      .IsRejected());
  EXPECT_TRUE(this->Calls.empty());
  this->ExpectUnchanged();
}

TEST_F(EditFilters, DecideOnFlipsAndMovesToo)
{
  EditWorkspace work;
  const Index vertex = this->MeshEditor->Mesh().Origin(0);
  const Vector3 position = 0.99 * this->MeshEditor->Mesh().Position(vertex);
  this->First->OfCheck = Rejection::ErrorBound;
  EXPECT_EQ(this->MeshEditor->Try(FlipOf(0), work), Rejection::ErrorBound);
  EXPECT_EQ(this->MeshEditor->Try(MoveTo(vertex, position), work), Rejection::ErrorBound);
  this->ExpectUnchanged();
  this->First->OfCheck = Decision::Accept();
  EXPECT_TRUE(this->MeshEditor->Try(FlipOf(0), work).IsAccepted());
  EXPECT_TRUE(this->MeshEditor->Try(MoveTo(vertex, position), work).IsAccepted());
  EXPECT_EQ(this->Second->Committed, (std::vector<EditKind>{ EditKind::Flip, EditKind::Move }));
  EXPECT_EQ(this->Rejections(), 0) << "neither is counted";
  EXPECT_EQ(this->MeshEditor->Mesh().Position(vertex), position);
}

TEST_F(EditFilters, GetTheSurfaceChangeOnlyIfOneNeedsIt)
{
  EXPECT_TRUE(this->Collapse().IsAccepted());
  EXPECT_EQ(this->First->ChangedFaces, 0U);
  this->Second->ReadsChange = true;
  EditorSettings settings{ false, false, false };
  settings.MoreFilters = { this->First, this->Second };
  this->MeshEditor.emplace(this->Cleaned, settings);
  EXPECT_TRUE(this->Collapse().IsAccepted());
  EXPECT_GT(this->First->ChangedFaces, 5U);
}
