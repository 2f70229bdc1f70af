// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlackMover.h
 * @brief Moves a vertex to where the faces around it use less of the error bound (SlackFit.h), so
 * that collapses find slack.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_SlackMover_h
#define BoneDecimate_Core_Decimate_Stages_SlackMover_h

#include "Decimate/Edit/Editor.h"
#include "SlackFit.h"

#include <vector>

namespace bonedecimate
{
class SlackMover
{
public:
  SlackMover(Editor& editor, Samples& samples, OriginalHints& hints)
    : MeshEditor(editor)
    , OriginalSamples(samples)
    , Hints(hints)
    , Slack(editor, samples, hints)
  {
  }

  struct Proposal
  {
    Index Vertex = None;                        ///< None: it does not move.
    Vector3 Position = Vector3::Zero();         ///< mm from the local origin
    Index Hint = None;                          ///< The original triangle near it.
    std::vector<Index> Ring = {};               ///< The faces of the vertex,
    std::vector<SlackFit::Member> Samples = {}; ///< and which sample is in which of them.
  };
  /// Reads the faces of the vertex only, so that vertices without a common face may be evaluated at
  /// the same time.
  Proposal Evaluate(VertexId vertex);

  /// By that step, if the faces then keep within the bound.  @param step mm
  Proposal Shift(VertexId vertex, const Vector3& step);

  /// Moves the vertex if the filters accept that. From one thread.  @return Whether it moved.
  bool Apply(const Proposal& proposal, EditWorkspace& workspace) const;

private:
  SlackFit::Value Gather(VertexId vertex);

  Editor& MeshEditor;
  Samples& OriginalSamples;
  OriginalHints& Hints;
  SlackFit Slack;
  std::vector<Index> Ring; // faces
};
}

#endif
