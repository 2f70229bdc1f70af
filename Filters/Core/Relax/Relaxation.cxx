// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Relaxation.h"

#include "EdgeFlipper.h"
#include "ErrorCollapse.h"
#include "VertexBlocks.h"
#include "VertexMover.h"

namespace bonedecimate
{
Relaxation::Relaxation(Editor& editor, const HalfEdgeMesh& original, int threads)
  : Work(editor)
  , Fit(original, !editor.IsGuaranteed())
  , Back(original)
  , Threads(threads)
{
}

//------------------------------------------------------------------------------
bool Relaxation::Begin(const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  this->IsSettled = this->Back.Begin(mesh, this->Threads, PartOf(monitor, 0.0, 0.1)) &&
    this->Fit.Distribute(mesh, this->Work.Reference(), this->Threads, PartOf(monitor, 0.1, 1.0));
  return this->IsSettled;
}

//------------------------------------------------------------------------------
bool Relaxation::Settle(const Monitor& monitor)
{
  this->IsSettled = this->IsSettled || this->Fit.Settle(this->Work.Mesh(), this->Threads, monitor);
  return this->IsSettled && monitor(1.0);
}

//------------------------------------------------------------------------------
bool Relaxation::Sweep(int times, const Monitor& monitor)
{
  constexpr double settledAt = 0.06;
  constexpr double flippedAt = 0.45;
  bool goesOn = true;
  this->Work.BeginSmallEdits();
  for (int i = 0; i < times && goesOn; ++i)
  {
    const Monitor sweep = PartOf(monitor, static_cast<double>(i) / times, (i + 1.0) / times);
    goesOn = this->Settle(PartOf(sweep, 0.0, settledAt)) &&
      this->FlipEdges(PartOf(sweep, settledAt, flippedAt)) &&
      this->MoveVertices(PartOf(sweep, flippedAt, 1.0));
  }
  this->Work.EndSmallEdits();
  return goesOn;
}

//------------------------------------------------------------------------------
bool Relaxation::FlipEdges(const Monitor& monitor)
{
  this->Work.ShareVolumes();
  VertexBlocks blocks(this->Work.Mesh());
  std::vector<float> faceErrors(
    static_cast<std::size_t>(this->Work.Mesh().NumberOfFaceSlots()), -1.0F);
  return blocks.ForEach(this->Work.Mesh(), this->EditThreads(), monitor,
    [&](VertexRange range)
    {
      return [flipper = EdgeFlipper(this->Work, this->Fit, this->Back, faceErrors, range,
                blocks.Count())](Index v) mutable { flipper.Improve(v); };
    });
}

//------------------------------------------------------------------------------
bool Relaxation::MoveVertices(const Monitor& monitor)
{
  this->IsSettled = false;
  this->Work.ShareVolumes();
  VertexBlocks blocks(this->Work.Mesh());
  return blocks.ForEach(this->Work.Mesh(), this->EditThreads(), monitor,
    [&](VertexRange range)
    {
      return [mover = VertexMover(this->Work, this->Fit, this->Back, range, blocks.Count())](
               Index v) mutable { mover.Improve(v); };
    });
}

//------------------------------------------------------------------------------
bool Relaxation::CollapseTo(Index faces, int edgesOfCollapse, const Monitor& monitor)
{
  constexpr double settledAt = 0.1;
  this->Work.ShareVolumes();
  this->Work.RenewQuadrics(this->Threads);
  return this->Settle(PartOf(monitor, 0.0, settledAt)) &&
    ErrorCollapse(this->Work, this->Fit, this->Back, edgesOfCollapse, this->Threads)
      .Run(faces, PartOf(monitor, settledAt, 1.0));
}
}
