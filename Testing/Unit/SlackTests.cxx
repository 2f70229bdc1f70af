// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Edits by how much of the error bound is left: compared with brute force, with the mesh before, and with the certificate.
#include "Certificate/Certificate.h"
#include "Edit/Editor.h"
#include "Mesh/Invariants.h"
#include "MeshState.h"
#include "Runs.h"
#include "Schedule/BucketSweep.h"
#include "Stages/PatchFit.h"
#include "Stages/SlackCandidates.h"
#include "Stages/SlackRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Limit = 0.3; // mm
const Monitor Always = [](double) { return true; };

/// A sphere of 10 mm that the sweep has simplified as far as the error allows.
struct Bench
{
  explicit Bench(double error = Limit, const Surface& surface = Icosphere(3, 10.0))
    : Cleaned(Clean(surface, true))
    , MeshEditor(this->Cleaned, Settings(error))
    , Fit(this->MeshEditor.BoundedMesh(), false, Limits(error))
    , Back(this->MeshEditor.BoundedMesh())
  {
    BucketSweep(this->MeshEditor, { 0, 0.0 }, 1).Run(Always);
    this->Back.Begin(this->Mesh(), 1, Always);
    this->Fit.Distribute(this->Mesh(), this->MeshEditor.Reference(), 1, Always);
    this->MeshEditor.DistributeVolumeBudget();
    this->MeshEditor.RenewQuadrics(1);
  }

  static EditorSettings Settings(double error)
  {
    EditorSettings settings;
    settings.RecordsDistances = false;
    settings.KeepsAreas = false;
    settings.KeepsQuadrics = true;
    settings.GuardsIntersections = true;
    settings.Bound = ErrorBoundSettings{ error };
    return settings;
  }
  std::vector<float> Limits(double error) const
  {
    return std::vector<float>(this->Cleaned.Surface.Points.size(), static_cast<float>(error));
  }

  const HalfEdgeMesh& Mesh() const { return this->MeshEditor.Mesh(); }

  /// The faces of a vertex, with their samples.
  std::vector<FaceId> Gather(VertexId vertex, SlackFit& slack) const
  {
    std::vector<FaceId> faces;
    slack.Clear();
    for (const HalfEdgeId h : this->Mesh().OutgoingOf(vertex))
    {
      slack.AddSamples(HalfEdgeMesh::Face(h), faces.size());
      slack.AddFace(this->Mesh().Position(this->Mesh().Target(h)),
        this->Mesh().Position(this->Mesh().Origin(HalfEdgeMesh::Previous(h))));
      faces.push_back(HalfEdgeMesh::Face(h));
    }
    return faces;
  }

  VertexId FirstVertex() const
  {
    VertexId v = 0;
    while (this->Mesh().Outgoing(v) == None)
    {
      v = v + 1;
    }
    return v;
  }

  ProofStatus Certified(double error) const
  {
    CertificateOptions options;
    options.Tolerance = error;
    options.TightBounds = false;
    options.NumberOfThreads = 1;
    return Certify(this->Cleaned.Surface, SurfaceOf(this->Mesh()), options).Proof;
  }

  CleanSurface Cleaned;
  Editor MeshEditor;
  Samples Fit;
  BackHints Back;
};

/// What a collapse with moves needs, for each edge of which one is found.
template <typename Use>
void ForEachFound(Bench& bench, double farthest, const Use& use)
{
  std::vector<SlackCandidate> candidates;
  SlackCandidates(bench.MeshEditor, bench.Fit, bench.Back, farthest, 1).Find(Always, candidates);
  std::sort(candidates.begin(), candidates.end());
  PatchFit patch(bench.MeshEditor, bench.Fit, bench.Back);
  Workspace work;
  for (const SlackCandidate& candidate : candidates)
  {
    if (candidate.Ratio > 1.0 && bench.MeshEditor.Validate(candidate.Edge, work).IsAccepted())
    {
      const PatchFit::Result found = patch.Fit(work.Around, candidate);
      if (found.IsWithin && !found.Moves.empty() && !use(candidate, found))
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

TEST(SlackFit, MeasuresSamplesAsBruteForceDoes)
{
  const Bench bench;
  SlackFit slack(bench.MeshEditor, bench.Fit, bench.Back);
  const VertexId vertex = bench.FirstVertex();
  const std::vector<FaceId> faces = bench.Gather(vertex, slack);
  const Vector3 position = 0.95 * bench.Mesh().Position(vertex);
  const double found = slack.LargestOfSamples(position, 1e9);
  double expected = 0.0; // limits
  for (const FaceId face : faces)
  {
    bench.Fit.VisitFace(face,
      [&](const Samples::Sample& sample)
      {
        double least = 1e9; // mm
        for (const HalfEdgeId h : bench.Mesh().OutgoingOf(vertex))
        {
          const TriangleFrame frame(position, bench.Mesh().Position(bench.Mesh().Target(h)),
            bench.Mesh().Position(bench.Mesh().Origin(HalfEdgeMesh::Previous(h))));
          least = std::min(
            least, std::sqrt(frame.Nearest(bench.Fit.SamplePosition(sample)).SquaredDistance));
        }
        expected = std::max(expected, least / sample.Limit);
      });
  }
  EXPECT_GT(expected, 0.5);
  EXPECT_NEAR(found, expected, 1e-6);
}

TEST(SlackFit, StepsLowerTheLargestDistance)
{
  const Bench bench;
  SlackFit slack(bench.MeshEditor, bench.Fit, bench.Back);
  const VertexId vertex = bench.FirstVertex();
  bench.Gather(vertex, slack);
  Vector3 position = 1.06 * bench.Mesh().Position(vertex);
  const double before = slack.Evaluate(position, bench.Back.Of(vertex)).Largest;
  EXPECT_GT(before, 1.9); // the vertex itself
  const SlackFit::Value after = slack.Improve(position, bench.Back.Of(vertex), 8);
  EXPECT_LT(after.Largest, 1.01);
  EXPECT_NEAR(slack.Evaluate(position, after.Hint).Largest, after.Largest, 1e-9);
}

TEST(SlackFit, GivesUpAtTheErrorThatIsEnough)
{
  const Bench bench;
  SlackFit slack(bench.MeshEditor, bench.Fit, bench.Back);
  const VertexId vertex = bench.FirstVertex();
  bench.Gather(vertex, slack);
  const Vector3 position = bench.Mesh().Position(vertex);
  const SlackFit::Value whole = slack.Evaluate(position, bench.Back.Of(vertex));
  EXPECT_GT(slack.Evaluate(position, whole.Hint, 0.9 * whole.Error).Error, 1e300);
  EXPECT_EQ(slack.Evaluate(position, whole.Hint, 1.1 * whole.Error).Error, whole.Error);
}

TEST(SlackRefinement, CollapsesMoreAfterSweepsAndKeepsTheBound)
{
  std::array<Index, 2> faces{};
  for (const int sweeps : { 0, 2 })
  {
    Bench bench;
    SlackRefinement slack(bench.MeshEditor, 1);
    EXPECT_TRUE(slack.Begin(Always) && slack.Sweep(sweeps, Always) && slack.Collapse(0, Always));
    faces[sweeps > 0 ? 1 : 0] = bench.Mesh().NumberOfFaces();
    EXPECT_EQ(BrokenInvariant(bench.Mesh()), "");
    EXPECT_EQ(bench.Certified(Limit), ProofStatus::Proved);
  }
  EXPECT_LT(faces[1], faces[0]);
}

TEST(SlackRefinement, StopsAtTheNumberOfFaces)
{
  Bench bench;
  SlackRefinement slack(bench.MeshEditor, 1);
  const Index target = bench.Mesh().NumberOfFaces() - 4;
  EXPECT_TRUE(slack.Begin(Always) && slack.Sweep(1, Always) && slack.Collapse(target, Always));
  EXPECT_EQ(bench.Mesh().NumberOfFaces(), target);
}

TEST(CollapseAndMove, IsProvedAsAWhole)
{
  Bench bench(Limit, BumpySphere(4, 10.0, 0.2, 7));
  int applied = 0;
  ForEachFound(bench, 1.4,
    [&](const SlackCandidate& candidate, const PatchFit::Result& found)
    {
      Workspace work;
      const Index faces = bench.Mesh().NumberOfFaces();
      if (bench.MeshEditor.CollapseAndMove(EditOf(candidate, found.Position), found.Moves, work, 1)
            .IsAccepted())
      {
        bench.MeshEditor.Settle(work.Counted);
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
  Bench bench(Limit, BumpySphere(4, 10.0, 0.2, 7));
  const std::vector<double> before = StateOf(bench.Mesh());
  int rejected = 0;
  ForEachFound(bench, 1.4,
    [&](const SlackCandidate& candidate, const PatchFit::Result& found)
    {
      Workspace work;
      std::vector<VertexMove> moves = found.Moves;
      moves.back().Position *= 1.05; // more than the limit away
      const Decision farMove =
        bench.MeshEditor.CollapseAndMove(EditOf(candidate, found.Position), moves, work, 1);
      const Decision withoutMoves =
        bench.MeshEditor.CollapseAndMove(EditOf(candidate, candidate.Position), {}, work, 1);
      EXPECT_TRUE(farMove.IsRejected());
      EXPECT_TRUE(withoutMoves.IsRejected());
      ++rejected;
      return rejected < 3;
    });
  EXPECT_GT(rejected, 0);
  EXPECT_EQ(StateOf(bench.Mesh()), before);
}

TEST(ForcedCollapse, RemovesMoreTheFartherItMayBegin)
{
  const Surface bumpy = BumpySphere(4, 10.0, 0.2, 7);
  Index before = Bench(Limit, bumpy).Mesh().NumberOfFaces();
  for (const double farthest : { 1.05, 1.5 })
  {
    Bench bench(Limit, bumpy);
    SlackRefinement slack(bench.MeshEditor, 1);
    EXPECT_TRUE(slack.Begin(Always) && slack.Force(0, farthest, Always));
    EXPECT_LT(bench.Mesh().NumberOfFaces(), before) << farthest;
    EXPECT_EQ(bench.Certified(Limit), ProofStatus::Proved);
    before = bench.Mesh().NumberOfFaces();
  }
}

TEST(ForcedCollapse, LeavesTheMeshWhereEditsAreRecorded)
{
  const CleanSurface clean = Clean(Icosphere(3, 10.0), true);
  EditorSettings settings = Bench::Settings(Limit);
  settings.RecordsEdits = true;
  Editor editor(clean, settings);
  BucketSweep(editor, { 0, 0.0 }, 1).Run(Always);
  const std::vector<double> before = StateOf(editor.Mesh());
  SlackRefinement slack(editor, 1);
  EXPECT_TRUE(slack.Begin(Always) && slack.Force(0, 1.5, Always));
  EXPECT_EQ(StateOf(editor.Mesh()), before);
}

TEST(ErrorBoundModes, NeedFewerTrianglesTheLongerTheyTake)
{
  const Surface input = BumpySphere(4, 10.0, 0.2, 7);
  std::size_t before = input.Triangles.size();
  double volume = 0.0; // mm^3, of Fast
  for (const Mode mode : { Mode::Fast, Mode::Balanced, Mode::Accurate })
  {
    const Result result = Decimate(input, InMode(mode, Error(Limit)));
    const double most = mode == Mode::Fast ? 1.0 : mode == Mode::Balanced ? 0.97 : 0.98;
    EXPECT_LT(result.Surface.Triangles.size(), most * before) << WordOf(mode);
    before = result.Surface.Triangles.size();
    double now = 0.0; // mm^3
    for (const Triangle& t : result.Surface.Triangles)
    {
      const std::vector<Vector3>& p = result.Surface.Points;
      now += p[t[0]].dot(p[t[1]].cross(p[t[2]])) / 6.0;
    }
    volume = mode == Mode::Fast ? now : volume;
    EXPECT_NEAR(now, volume, 0.005 * volume) << WordOf(mode);
  }
}

TEST(ErrorBoundModes, GiveTheSameBytesForAnyNumberOfThreads)
{
  for (const Mode mode : { Mode::Balanced, Mode::Accurate })
  {
    ExpectTheSameBytesForAnyNumberOfThreads(BumpySphere(3, 10.0, 0.2, 7), InMode(mode, Error(0.3)));
  }
}
