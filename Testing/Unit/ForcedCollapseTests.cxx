// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Collapses that keep the error bound only together with moves around them, and the modes that make
// them.
#include "Decimate/Stages/PatchFit.h"
#include "Decimate/Stages/SlackCandidates.h"
#include "Decimate/Stages/SlackRefinement.h"
#include "Levels/LevelStack.h"
#include "Mesh/Invariants.h"
#include "MeshState.h"
#include "SlackBench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// What a collapse with moves needs, for each edge of which one is found.
template <typename Use>
void ForEachFound(Bench& bench, double farthest, const Use& use)
{
  std::vector<SlackCandidate> candidates;
  SlackCandidates(bench.MeshEditor, bench.Fit, bench.Back, farthest, 1).Find(Always, candidates);
  std::sort(candidates.begin(), candidates.end());
  PatchFit patch(bench.MeshEditor, bench.Fit, bench.Back, 1);
  EditWorkspace work;
  for (const SlackCandidate& candidate : candidates)
  {
    if (candidate.Ratio > 1.0 && bench.MeshEditor.Gather(candidate.Edge, work).IsAccepted())
    {
      const PatchFit::Result found = patch.Fit(work.Neighborhood, candidate);
      if (found.IsWithin && !found.Nearby.Moves.empty() && !use(candidate, found))
      {
        return;
      }
    }
  }
}

Edit EditOf(const SlackCandidate& candidate, const Vector3& position)
{
  Edit edit;
  edit.Edge = candidate.Edge;
  edit.Keep = candidate.Start;
  edit.Position = position;
  return edit;
}
}

TEST(CollapseAndMove, IsProvedAsAWhole)
{
  Bench bench(Limit, BumpySphere(3, 10.0, 0.2, 7));
  int applied = 0;
  ForEachFound(bench, 1.4,
    [&](const SlackCandidate& candidate, const PatchFit::Result& found)
    {
      EditWorkspace work;
      const Index faces = bench.Mesh().NumberOfFaces();
      if (bench.MeshEditor.Try(EditOf(candidate, found.Position), found.Nearby, work).IsAccepted())
      {
        EXPECT_EQ(bench.Mesh().NumberOfFaces(), faces - 2);
        EXPECT_EQ(BrokenInvariant(bench.Mesh()), "");
        EXPECT_EQ(bench.Certified(Limit), ProofStatus::Proved);
        ++applied;
      }
      return applied == 0;
    });
  EXPECT_EQ(applied, 1);
}

TEST(CollapseAndMove, LeavesEveryByteIfItIsRejected)
{
  Bench bench(Limit, BumpySphere(3, 10.0, 0.2, 7));
  const std::vector<double> before = StateOf(bench.Mesh());
  int rejected = 0;
  ForEachFound(bench, 1.4,
    [&](const SlackCandidate& candidate, const PatchFit::Result& found)
    {
      EditWorkspace work;
      NearbyEdits tooFar = found.Nearby;
      tooFar.Moves.back().Position *= 1.05; // more than the limit away
      const Decision farMove =
        bench.MeshEditor.Try(EditOf(candidate, found.Position), tooFar, work);
      const Decision withoutMoves =
        bench.MeshEditor.Try(EditOf(candidate, candidate.Position), {}, work);
      EXPECT_TRUE(farMove.IsRejected());
      EXPECT_TRUE(withoutMoves.IsRejected());
      ++rejected;
      return rejected < 3;
    });
  EXPECT_GT(rejected, 0);
  EXPECT_EQ(StateOf(bench.Mesh()), before);
}

TEST(CollapseAndMove, NeedsTheFlipsOfThePatch)
{
  Bench bench(Limit, BumpySphere(3, 10.0, 0.2, 7));
  const std::vector<double> before = StateOf(bench.Mesh());
  int applied = 0;
  ForEachFound(bench, 1.5,
    [&](const SlackCandidate& candidate, const PatchFit::Result& found)
    {
      EditWorkspace work;
      const Edit edit = EditOf(candidate, found.Position);
      if (found.Nearby.Flips.empty() ||
        bench.MeshEditor.Try(edit, { found.Nearby.Moves, {} }, work).IsAccepted())
      {
        return StateOf(bench.Mesh()) == before;
      }
      EXPECT_EQ(StateOf(bench.Mesh()), before);
      NearbyEdits impossible = found.Nearby;
      impossible.Flips.push_back({ candidate.Start, candidate.End });
      EXPECT_TRUE(bench.MeshEditor.Try(edit, impossible, work).IsRejected());
      EXPECT_EQ(StateOf(bench.Mesh()), before);
      if (bench.MeshEditor.Try(edit, found.Nearby, work).IsAccepted())
      {
        EXPECT_EQ(BrokenInvariant(bench.Mesh()), "");
        EXPECT_EQ(bench.Certified(Limit), ProofStatus::Proved);
        ++applied;
      }
      return applied == 0;
    });
  EXPECT_EQ(applied, 1);
}

TEST(ForcedCollapse, RemovesMoreTheFartherItMayBegin)
{
  const Surface bumpy = BumpySphere(3, 10.0, 0.2, 7);
  const Index atFirst = Bench(Limit, bumpy).Mesh().NumberOfFaces();
  Index before = atFirst;
  for (const double farthest : { 1.05, 1.5 })
  {
    Bench bench(Limit, bumpy);
    SlackRefinement slack(bench.MeshEditor, 1);
    ForcedCollapseFigures figures;
    EXPECT_TRUE(slack.Begin(Always) && slack.Force(0, { farthest, 1 }, Always, figures));
    EXPECT_EQ(atFirst - 2 * figures.Made, bench.Mesh().NumberOfFaces());
    EXPECT_LE(figures.Made, figures.Tried);
    EXPECT_LT(bench.Mesh().NumberOfFaces(), before) << farthest;
    EXPECT_EQ(bench.Certified(Limit), ProofStatus::Proved);
    before = bench.Mesh().NumberOfFaces();
  }
}

TEST(ForcedCollapse, IsOneStepOfTheLog)
{
  const CleanSurface clean = Clean(BumpySphere(3, 10.0, 0.2, 7), true);
  EditorSettings settings = Guarded(Limit);
  settings.RecordsEdits = true;
  Editor editor(clean, settings);
  BucketSweep(editor, 1).Run({ 0, 0.0 }, Always);
  const std::int64_t before = editor.Totals().Collapses;
  SlackRefinement slack(editor, 1);
  ForcedCollapseFigures figures;
  EXPECT_TRUE(slack.Begin(Always) && slack.Force(0, { 1.5, 1 }, Always, figures));
  EXPECT_GT(figures.Made, 0);
  EXPECT_EQ(editor.Totals().Collapses, before + figures.Made);
  EditLog log = editor.TakeLog();
  log.Vertices = editor.Mesh().NumberOfVertexSlots();
  log.Faces = editor.Mesh().NumberOfFaceSlots();
  const std::optional<LevelStack> levels = LevelStack::Build(clean.Surface.Triangles, log);
  ASSERT_TRUE(levels);
  CertificateOptions options;
  options.Tolerance = Limit;
  options.TightBounds = false;
  options.NumberOfThreads = 1;
  for (Index level = static_cast<Index>(before); level <= levels->NumberOfCollapses(); ++level)
  {
    const Surface found = levels->At(level, 1, clean.Surface.Points, {}).Surface;
    EXPECT_EQ(Certify(clean.Surface, found, options).Proof, ProofStatus::Proved) << level;
  }
  const Surface last = levels->At(levels->NumberOfCollapses(), 1, clean.Surface.Points, {}).Surface;
  const Surface result = SurfaceOf(editor.Mesh());
  ASSERT_EQ(last.Triangles.size(), result.Triangles.size());
  for (std::size_t i = 0; i < last.Triangles.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_EQ(last.Points[last.Triangles[i][k]], result.Points[result.Triangles[i][k]]);
    }
  }
}

TEST(ErrorBoundModes, NeedFewerTrianglesTheLongerTheyTake)
{
  const Surface input = BumpySphere(4, 10.0, 0.2, 7);
  std::size_t before = input.Triangles.size();
  const double volume = VolumeOf(input);
  for (const Mode mode : { Mode::Fast, Mode::Balanced, Mode::Accurate })
  {
    const Result result = Decimate(input, InMode(mode, Error(Limit)));
    const double most = mode == Mode::Fast ? 1.0 : mode == Mode::Balanced ? 0.97 : 0.98;
    EXPECT_LT(result.Surface.Triangles.size(), most * before) << WordOf(mode);
    before = result.Surface.Triangles.size();
    EXPECT_NEAR(VolumeOf(result.Surface), volume, 0.002 * volume) << WordOf(mode);
  }
}

TEST(ErrorBoundModes, ComeNearToTheLeastNumberOfTrianglesOfASphere)
{
  constexpr double radius = 10.0; // mm
  constexpr double error = 0.1;   // mm
  // Vertices outside by the error, centers of faces inside by it.
  const double least = 4.0 * 3.14159265358979 * radius / (3.0 * std::sqrt(3.0) * error);
  const Result result = Decimate(Icosphere(4, radius), InMode(Mode::Accurate, Error(error)));
  EXPECT_LT(result.Surface.Triangles.size(), 1.3 * least);
  EXPECT_GT(result.Report.Edits.Forced.Made, result.Report.Edits.Forced.Tried / 10);
}

TEST(ErrorBoundModes, NeedFewerTrianglesForMoreEffort)
{
  const Surface input = BumpySphere(3, 10.0, 0.2, 7);
  for (const Mode mode : { Mode::Balanced, Mode::Accurate })
  {
    std::size_t before = Decimate(input, InMode(Mode::Fast, Error(Limit))).Surface.Triangles.size();
    for (const double effort : { 0.0, 1.0 })
    {
      Options options = InMode(mode, Error(Limit));
      options.RefinementEffort = effort;
      const Result result = Decimate(input, options);
      EXPECT_LT(result.Surface.Triangles.size(), effort == 0.0 ? before + 1 : before)
        << WordOf(mode) << " " << effort;
      EXPECT_EQ(result.Report.Edits.Forced.Tried > 0, mode == Mode::Accurate && effort > 0.0);
      before = result.Surface.Triangles.size();
    }
  }
}

TEST(ErrorBoundModes, GiveTheSameBytesForAnyNumberOfThreads)
{
  for (const Mode mode : { Mode::Balanced, Mode::Accurate })
  {
    ExpectTheSameBytesForAnyNumberOfThreads(BumpySphere(3, 10.0, 0.2, 7), InMode(mode, Error(0.3)));
  }
}
