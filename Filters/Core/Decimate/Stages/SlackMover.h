// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlackMover.h
 * @brief Moves a vertex to where the faces around it use less of the error bound (SlackFit.h). The
 * slack allows more collapses.
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
    Index Hint = None;                          ///< An original triangle near it.
    std::vector<Index> Ring = {};               ///< Faces of the vertex.
    std::vector<SlackFit::Member> Samples = {}; ///< Samples with their index in Ring.
  };
  /// Proposes a step. Reads the faces of the vertex only, so vertices without a common face may be
  /// evaluated in parallel.
  Proposal Evaluate(VertexId vertex);

  /// Proposes the given step if the faces then keep within the bound. @param step mm
  Proposal Shift(VertexId vertex, const Vector3& step);

  /// Moves the vertex if the filters accept the move; on one thread. @return Whether it moved.
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
