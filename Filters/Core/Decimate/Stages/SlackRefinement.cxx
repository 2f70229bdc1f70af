// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlackRefinement.h"

#include "Base/Parallel.h"
#include "SlackCollapse.h"
#include "SlackFlipper.h"
#include "SlackMover.h"
#include "VolumeMover.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
constexpr std::size_t VerticesOfTask = 16;
}

SlackRefinement::SlackRefinement(Editor& editor, int threads)
  : SampledRefinement(editor,
      Samples(editor.Original().BoundedMesh(), false, editor.Bound()->LimitsOfVertices()),
      editor.Original().BoundedMesh(), threads)
{
}

//------------------------------------------------------------------------------
bool SlackRefinement::Sweep(int times, const Monitor& monitor)
{
  constexpr double flippedAt = 0.15;
  return this->RepeatSweeps(times, monitor,
    [this](const Monitor& sweep)
    {
      return SlackFlipper(this->MeshEditor, this->OriginalSamples, this->Hints)
               .Run(PartOf(sweep, 0.0, flippedAt)) &&
        this->MoveVertices(PartOf(sweep, flippedAt, 1.0));
    });
}

//------------------------------------------------------------------------------
bool SlackRefinement::MoveVertices(const Monitor& monitor)
{
  this->IsSettled = false;
  const std::vector<std::vector<Index>> colors = this->ColorVertices();
  return this->MeshEditor.FlipAndMove(
    [&]
    {
      bool shouldContinue = true;
      for (std::size_t i = 0; i < colors.size() && shouldContinue; ++i)
      {
        shouldContinue = this->MoveAll(colors[i], StepOf(monitor, i, colors.size()));
      }
      return shouldContinue;
    });
}

//------------------------------------------------------------------------------
/// Gives each vertex, in order, the first color that no neighbor has. So vertices of one color have
/// no face in common.
std::vector<std::vector<Index>> SlackRefinement::ColorVertices() const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  std::vector<std::vector<Index>> colors;
  std::vector<Index> colorOf(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), None);
  std::vector<char> isTaken;
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.Outgoing(v) == None || !MayMove(mesh, v))
    {
      continue;
    }
    isTaken.assign(colors.size() + 1, 0);
    mesh.VisitNeighbors(v,
      [&](HalfEdgeId, Index other)
      {
        if (colorOf[other] != None)
        {
          isTaken[colorOf[other]] = 1;
        }
      });
    const auto color = std::find(isTaken.begin(), isTaken.end(), 0) - isTaken.begin();
    colors.resize(std::max(colors.size(), static_cast<std::size_t>(color) + 1));
    colorOf[v] = static_cast<Index>(color);
    colors[static_cast<std::size_t>(color)].push_back(v);
  }
  return colors;
}

//------------------------------------------------------------------------------
/// @param vertices No two of them have a face in common.
bool SlackRefinement::MoveAll(const std::vector<Index>& vertices, const Monitor& monitor)
{
  constexpr double evaluatedAt = 0.6;
  std::vector<SlackMover::Proposal> proposals(vertices.size());
  const bool shouldContinue = ForEachPart((vertices.size() + VerticesOfTask - 1) / VerticesOfTask,
    this->Threads, PartOf(monitor, 0.0, evaluatedAt),
    [&](std::size_t part)
    {
      SlackMover mover(this->MeshEditor, this->OriginalSamples, this->Hints);
      const std::size_t end = std::min(vertices.size(), (part + 1) * VerticesOfTask);
      for (std::size_t i = part * VerticesOfTask; i < end; ++i)
      {
        proposals[i] = mover.Evaluate(vertices[i]);
      }
    });
  if (!shouldContinue)
  {
    return false;
  }
  const SlackMover mover(this->MeshEditor, this->OriginalSamples, this->Hints);
  EditWorkspace workspace;
  for (const SlackMover::Proposal& proposal : proposals)
  {
    if (proposal.Vertex != None)
    {
      mover.Apply(proposal, workspace);
    }
  }
  this->MeshEditor.Settle(&workspace.Counts);
  return monitor(1.0);
}

//------------------------------------------------------------------------------
bool SlackRefinement::Collapse(Index faces, const Monitor& monitor)
{
  this->MeshEditor.PrepareCollapses(this->Threads);
  return this->SettleSamples(PartOf(monitor, 0.0, SettledAt)) &&
    SlackCollapse(this->MeshEditor, this->OriginalSamples, this->Hints, this->Threads)
      .Run(faces, PartOf(monitor, SettledAt, 1.0));
}

//------------------------------------------------------------------------------
bool SlackRefinement::Force(
  Index faces, ForcedReach reach, const Monitor& monitor, ForcedCollapseFigures& figures)
{
  this->MeshEditor.PrepareCollapses(this->Threads);
  if (!this->SettleSamples(PartOf(monitor, 0.0, SettledAt)))
  {
    return false;
  }
  ForcedCollapse collapse(
    this->MeshEditor, this->OriginalSamples, this->Hints, reach, this->Threads);
  const bool shouldContinue = collapse.Run(faces, PartOf(monitor, SettledAt, 1.0));
  figures.Tried += collapse.Report().Tried;
  figures.Made += collapse.Report().Made;
  return shouldContinue;
}

//------------------------------------------------------------------------------
bool SlackRefinement::RestoreVolume(const Monitor& monitor)
{
  this->IsSettled = false; // other edits may have come since
  return this->SettleSamples(PartOf(monitor, 0.0, SettledAt)) &&
    VolumeMover(this->MeshEditor, this->OriginalSamples, this->Hints)
      .Run(PartOf(monitor, SettledAt, 1.0));
}
}
