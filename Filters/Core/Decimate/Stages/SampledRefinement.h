// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledRefinement.h
 * @brief What Refinement and SlackRefinement have in common: samples of the original, assigned to
 * the faces of the current mesh.
 *
 *     Begin:         distribute the samples over the faces
 *     RepeatSweeps:  let the samples settle  ->  a sweep of flips and moves
 */
#ifndef BoneDecimate_Core_Decimate_Stages_SampledRefinement_h
#define BoneDecimate_Core_Decimate_Stages_SampledRefinement_h

#include "Decimate/Edit/Editor.h"
#include "Proof/Reference/OriginalHints.h"
#include "Proof/Reference/Samples.h"

#include <functional>

namespace bonedecimate
{
class SampledRefinement
{
public:
  /// Must be called first, and after others have collapsed or split edges. False if the monitor
  /// requests a stop; the surface is valid then, too.
  bool Begin(const Monitor& monitor);

protected:
  /// @param samples Samples of `original`, which must outlive this.
  SampledRefinement(Editor& editor, Samples samples, const HalfEdgeMesh& original, int threads);

  /// The fraction of a sweep at which the samples have settled.
  static constexpr double SettledAt = 0.06;

  /// Moves each sample to the face nearest to it, unless no vertex has moved since the last time.
  bool SettleSamples(const Monitor& monitor);
  /// Calls sweep(monitor) that many times, each time with settled samples.
  bool RepeatSweeps(
    int times, const Monitor& monitor, const std::function<bool(const Monitor&)>& sweep);

  Editor& MeshEditor;
  Samples OriginalSamples;
  OriginalHints Hints;
  int Threads;
  bool IsSettled = false; // whether no vertex has moved since the samples settled
};
}

#endif
