// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlackFlipper.h
 * @brief Flips edges whose other diagonal uses less of the error bound (SlackFit.h).
 *
 * Collapses leave vertices with many edges beside vertices with few, and moves alone cannot
 * compensate for this.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_SlackFlipper_h
#define BoneDecimate_Core_Decimate_Stages_SlackFlipper_h

#include "Decimate/Edit/Editor.h"
#include "SlackFit.h"

#include <array>

namespace bonedecimate
{
class SlackFlipper
{
public:
  SlackFlipper(Editor& editor, Samples& samples, OriginalHints& hints)
    : MeshEditor(editor)
    , OriginalSamples(samples)
    , Hints(hints)
    , Slack(editor, samples, hints)
  {
  }

  /// Tries every edge once, on one thread. False if the monitor requests a stop.
  bool Run(const Monitor& monitor);

private:
  /// Reads two faces that have the edge from the first to the third corner in common.
  void Gather(const std::array<Vector3, 4>& corners, const std::array<FaceId, 2>& faces);
  void TryFlip(HalfEdgeId edge);
  bool Improves(HalfEdgeId edge);

  Editor& MeshEditor;
  Samples& OriginalSamples;
  OriginalHints& Hints;
  SlackFit Slack;
  EditWorkspace Workspace;
};
}

#endif
