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
constexpr double SettledAt = 0.06; // of a sweep
constexpr double FlippedAt = 0.2;
}

SlackRefinement::SlackRefinement(Editor& editor, int threads)
  : MeshEditor(editor)
  , Fit(editor.Original().BoundedMesh(), false, editor.Bound()->LimitsOfVertices())
  , Back(editor.Original().BoundedMesh(), editor.Original().NearInitial())
  , Threads(editor.HasHook() ? 1 : threads)
{
}

//------------------------------------------------------------------------------
bool SlackRefinement::Begin(const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  this->IsSettled = this->Back.Restart(mesh, this->Threads, PartOf(monitor, 0.0, 0.1)) &&
    this->Fit.Distribute(mesh, this->MeshEditor.Original().CurrentOfInitial(), this->Threads,
      PartOf(monitor, 0.1, 1.0));
  return this->IsSettled;
}

//------------------------------------------------------------------------------
bool SlackRefinement::Settle(const Monitor& monitor)
{
  this->IsSettled =
    this->IsSettled || this->Fit.Settle(this->MeshEditor.Mesh(), this->Threads, monitor);
  return this->IsSettled && monitor(1.0);
}

//------------------------------------------------------------------------------
bool SlackRefinement::Sweep(int times, const Monitor& monitor)
{
  return this->MeshEditor.FlipAndMove(
    [&]
    {
      bool goesOn = true;
      for (int i = 0; i < times && goesOn; ++i)
      {
        const Monitor sweep = PartOf(monitor, static_cast<double>(i) / times, (i + 1.0) / times);
        goesOn = this->Settle(PartOf(sweep, 0.0, SettledAt)) &&
          SlackFlipper(this->MeshEditor, this->Fit, this->Back)
            .Run(PartOf(sweep, SettledAt, FlippedAt)) &&
          this->MoveVertices(PartOf(sweep, FlippedAt, 1.0));
      }
      return goesOn;
    });
}

//------------------------------------------------------------------------------
bool SlackRefinement::MoveVertices(const Monitor& monitor)
{
  this->IsSettled = false;
  const std::vector<std::vector<Index>> colors = this->ColorVertices();
  const double count = static_cast<double>(colors.size());
  return this->MeshEditor.FlipAndMove(
    [&]
    {
      bool goesOn = true;
      for (std::size_t i = 0; i < colors.size() && goesOn; ++i)
      {
        goesOn = this->MoveAll(colors[i], PartOf(monitor, i / count, (i + 1) / count));
      }
      return goesOn;
    });
}

//------------------------------------------------------------------------------
/// The least color that no neighbor has, in the order of the vertices: vertices of one color have
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
/// @param vertices Vertices of which no two have a face in common.
bool SlackRefinement::MoveAll(const std::vector<Index>& vertices, const Monitor& monitor)
{
  constexpr double evaluatedAt = 0.6;
  std::vector<SlackMover::Proposal> proposals(vertices.size());
  const bool goesOn = ForEachPart((vertices.size() + VerticesOfTask - 1) / VerticesOfTask,
    this->Threads, PartOf(monitor, 0.0, evaluatedAt),
    [&](std::size_t part)
    {
      SlackMover mover(this->MeshEditor, this->Fit, this->Back);
      const std::size_t end = std::min(vertices.size(), (part + 1) * VerticesOfTask);
      for (std::size_t i = part * VerticesOfTask; i < end; ++i)
      {
        proposals[i] = mover.Evaluate(vertices[i]);
      }
    });
  if (!goesOn)
  {
    return false;
  }
  const SlackMover mover(this->MeshEditor, this->Fit, this->Back);
  Workspace work;
  for (const SlackMover::Proposal& proposal : proposals)
  {
    if (proposal.Vertex != None)
    {
      mover.Apply(proposal, work);
    }
  }
  this->MeshEditor.Settle(&work.Counted);
  return monitor(1.0);
}

//------------------------------------------------------------------------------
bool SlackRefinement::Collapse(Index faces, const Monitor& monitor)
{
  this->MeshEditor.PrepareCollapses(this->Threads);
  return this->Settle(PartOf(monitor, 0.0, SettledAt)) &&
    SlackCollapse(this->MeshEditor, this->Fit, this->Back, this->Threads)
      .Run(faces, PartOf(monitor, SettledAt, 1.0));
}

//------------------------------------------------------------------------------
bool SlackRefinement::Force(
  Index faces, ForcedReach reach, const Monitor& monitor, ForcedCollapseFigures& figures)
{
  this->MeshEditor.PrepareCollapses(this->Threads);
  if (!this->Settle(PartOf(monitor, 0.0, SettledAt)))
  {
    return false;
  }
  ForcedCollapse collapse(this->MeshEditor, this->Fit, this->Back, reach, this->Threads);
  const bool goesOn = collapse.Run(faces, PartOf(monitor, SettledAt, 1.0));
  figures.Tried += collapse.Report().Tried;
  figures.Made += collapse.Report().Made;
  return goesOn;
}

//------------------------------------------------------------------------------
bool SlackRefinement::RestoreVolume(const Monitor& monitor)
{
  this->IsSettled = false; // other edits may have come since
  return this->Settle(PartOf(monitor, 0.0, SettledAt)) &&
    VolumeMover(this->MeshEditor, this->Fit, this->Back).Run(PartOf(monitor, SettledAt, 1.0));
}
}
