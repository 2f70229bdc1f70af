// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Relaxation.h"

#include "EdgeFlipper.h"
#include "VertexMover.h"
#include <cstdlib>
#include <cstring>

namespace bonedecimate
{
Relaxation::Relaxation(Editor& editor, const HalfEdgeMesh& original, int threads)
  : Work(editor)
  , Fit(original)
  , Back(original)
  , Threads(threads)
{
}

//------------------------------------------------------------------------------
bool Relaxation::Run(int sweeps, const Monitor& monitor)
{
  const int steps = 1 + 3 * sweeps;
  int step = 0;
  const auto next = [&]
  {
    const double from = static_cast<double>(step) / steps;
    const double size = 1.0 / steps;
    ++step;
    return Monitor([&monitor, from, size](double done) { return monitor(from + done * size); });
  };
  bool goesOn = this->Begin(next());
  for (int sweep = 0; sweep < sweeps && goesOn; ++sweep)
  {
    const char* w=getenv("WHAT"); if(!w) w="fm";
    goesOn = (!strchr(w,'f')||this->FlipEdges(next())) && (!strchr(w,'m')||this->MoveVertices(next())) &&
      this->Fit.Settle(this->Work.Mesh(), this->Threads, next());
  }
  return goesOn;
}

//------------------------------------------------------------------------------
bool Relaxation::Begin(const Monitor& monitor)
{
  this->Back.Begin(this->Work.Mesh());
  return this->Fit.Distribute(
    this->Work.Mesh(), this->Work.Reference(), this->Threads, monitor);
}

//------------------------------------------------------------------------------
bool Relaxation::FlipEdges(const Monitor& monitor)
{
  this->Work.ShareVolumes();
  VertexBlocks blocks(this->Work.Mesh());
  return blocks.ForEach(this->Work.Mesh(), this->EditThreads(), monitor,
      [&]
      {
        return [flipper = EdgeFlipper(this->Work, this->Fit, this->Back, blocks.Count())](Index v) mutable
        { flipper.Improve(v); };
      });
}

//------------------------------------------------------------------------------
bool Relaxation::MoveVertices(const Monitor& monitor)
{
  this->Work.ShareVolumes();
  VertexBlocks blocks(this->Work.Mesh());
  return blocks.ForEach(this->Work.Mesh(), this->EditThreads(), monitor,
      [&]
      {
        return [mover = VertexMover(this->Work, this->Fit, this->Back, blocks.Count())](Index v) mutable
        { mover.Improve(v); };
      });
}
}
