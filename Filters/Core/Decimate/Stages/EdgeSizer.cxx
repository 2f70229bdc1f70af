// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeSizer.h"

#include "EdgesByLength.h"
#include "ShapeImprover.h"
#include "ShapeLoop.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr int MaxRounds = 8;
/// An edge as long as a bone reaches any useful length in fewer passes.
constexpr int MaxSplitPasses = 24;
/// No further round after one with less than one collapse or split for this many faces.
constexpr std::int64_t MinOfRound = 256;
}

EdgeSizer::EdgeSizer(Editor& editor, const ShapeLimits& limits, int threads)
  : MeshEditor(editor)
  , Limits(limits)
  , Threads(threads)
  , Lengths(limits.Sizing, editor.Mesh(), threads)
  , Collapser(editor, limits.MaxCosine, CosineOfRelaxed)
{
}

//------------------------------------------------------------------------------
/// Whether the predicate holds for the ratio of an edge to its local length; true if there are no
/// local lengths.
template <typename Predicate>
bool EdgeSizer::IsLocally(HalfEdgeId edge, const Predicate& predicate)
{
  if (!this->Limits.Sizing)
  {
    return true;
  }
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const auto lengthAt = [&](VertexId vertex)
  { return this->Lengths.Update(vertex, mesh.Position(vertex)); };
  const double length = std::min(lengthAt(mesh.Origin(edge)), lengthAt(mesh.Target(edge)));
  return predicate(std::sqrt(SquaredLength(mesh, edge)) / length);
}

//------------------------------------------------------------------------------
bool EdgeSizer::Run(Index faces, const Monitor& monitor)
{
  constexpr double collapsedAt = 0.4; // of a round
  constexpr double splitAt = 0.6;
  constexpr double roundsAt = 0.95;
  const Monitor rounds = PartOf(monitor, 0.0, roundsAt);
  bool shouldContinue = true;
  bool isWorthIt = true;
  for (int i = 0; i < MaxRounds && shouldContinue && isWorthIt; ++i)
  {
    const auto edits = [this]
    { return this->MeshEditor.Totals().Collapses + this->MeshEditor.Totals().Splits; };
    const std::int64_t before = edits();
    const Monitor round = StepOf(rounds, i, MaxRounds);
    shouldContinue = this->Collapse(faces, PartOf(round, 0.0, collapsedAt)) &&
      this->Split(faces, PartOf(round, collapsedAt, splitAt)) &&
      ShapeImprover::Relax(this->MeshEditor, PartOf(round, splitAt, 1.0));
    isWorthIt = (edits() - before) * MinOfRound >= this->MeshEditor.Mesh().NumberOfFaces();
  }
  return shouldContinue && this->Split(faces, PartOf(monitor, roundsAt, 1.0));
}

//------------------------------------------------------------------------------
bool EdgeSizer::Collapse(Index faces, const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  this->MeshEditor.PrepareCollapses(this->Threads);
  const std::vector<EdgeOfLength> edges = EdgesByLength(mesh, -1.0, this->Limits.CollapseLength());
  return ForEachOf(edges.size(), monitor,
    [&](std::size_t i)
    {
      const HalfEdgeId edge = edges[i].Edge;
      if (IsUnchanged(mesh, edges[i]) && mesh.NumberOfFaces() > faces &&
        this->IsLocally(edge, [](double ratio) { return ratio < ShapeLimits::CollapseRatio; }))
      {
        this->Collapser.Try(edge);
      }
    });
}

//------------------------------------------------------------------------------
/// Splits edges until none can be split.
bool EdgeSizer::Split(Index faces, const Monitor& monitor)
{
  if (!this->MeshEditor.PrepareSplits())
  {
    return monitor(1.0);
  }
  std::int64_t splits = 1;
  bool shouldContinue = true;
  for (int pass = 0; pass < MaxSplitPasses && splits > 0 && shouldContinue; ++pass)
  {
    const Monitor part = StepOf(monitor, pass, MaxSplitPasses);
    shouldContinue = this->SplitOnce(faces, splits, part);
  }
  return shouldContinue && monitor(1.0);
}

//------------------------------------------------------------------------------
bool EdgeSizer::SplitOnce(Index faces, std::int64_t& splits, const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const std::vector<EdgeOfLength> edges = EdgesByLength(mesh, this->Limits.MinSplitLength());
  splits = 0;
  return ForEachOf(edges.size(), monitor,
    [&](std::size_t i)
    {
      const EdgeOfLength& edge = edges[edges.size() - 1 - i];
      const bool mayGrow = faces == 0 || mesh.NumberOfFaces() + 2 <= faces;
      if (IsUnchanged(mesh, edge) && mayGrow)
      {
        splits += this->SplitInTheMiddle(edge.Edge) ? 1 : 0;
      }
    });
}

//------------------------------------------------------------------------------
/// Splits the edge if it is too long for its local length. Returns whether it was split.
bool EdgeSizer::SplitInTheMiddle(HalfEdgeId edge)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (!this->IsLocally(edge, [](double ratio) { return ratio > ShapeLimits::SplitRatio; }))
  {
    return false;
  }
  const Vector3 middle =
    0.5 * (mesh.Position(mesh.Origin(edge)) + mesh.Position(mesh.Target(edge)));
  const bool isSplit = this->MeshEditor.Try(SplitAt(edge, middle), this->Workspace).IsAccepted();
  this->MeshEditor.Settle(&this->Workspace.Counts);
  return isSplit;
}
}
