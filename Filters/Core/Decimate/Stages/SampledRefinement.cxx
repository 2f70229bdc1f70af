// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampledRefinement.h"

#include <utility>

namespace bonedecimate
{
/// With a hook only one worker may be active.
SampledRefinement::SampledRefinement(
  Editor& editor, Samples samples, const HalfEdgeMesh& original, int threads)
  : MeshEditor(editor)
  , OriginalSamples(std::move(samples))
  , Hints(original, editor.Original().NearInitial())
  , Threads(editor.HasHook() ? 1 : threads)
{
}

//------------------------------------------------------------------------------
bool SampledRefinement::Begin(const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  this->IsSettled = this->Hints.Restart(mesh, this->Threads, PartOf(monitor, 0.0, 0.1)) &&
    this->OriginalSamples.Distribute(mesh, this->MeshEditor.Original().CurrentOfInitial(),
      this->Threads, PartOf(monitor, 0.1, 1.0));
  return this->IsSettled;
}

//------------------------------------------------------------------------------
bool SampledRefinement::SettleSamples(const Monitor& monitor)
{
  this->IsSettled = this->IsSettled ||
    this->OriginalSamples.Settle(this->MeshEditor.Mesh(), this->Threads, monitor);
  return this->IsSettled && monitor(1.0);
}

//------------------------------------------------------------------------------
bool SampledRefinement::RepeatSweeps(
  int times, const Monitor& monitor, const std::function<bool(const Monitor&)>& sweep)
{
  return this->MeshEditor.FlipAndMove(
    [&]
    {
      bool shouldContinue = true;
      for (int i = 0; i < times && shouldContinue; ++i)
      {
        const Monitor step = StepOf(monitor, i, times);
        shouldContinue =
          this->SettleSamples(PartOf(step, 0.0, SettledAt)) && sweep(PartOf(step, SettledAt, 1.0));
      }
      return shouldContinue;
    });
}
}
