// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlackCollapse.h
 * @brief Collapses edges whose merged vertex can move to where the faces around it keep the error
 * bound (SlackFit.h).
 *
 *     a round:
 *         in parallel:     evaluate the edges near changes: candidates have a ratio up to 1
 *                                                                           (SlackCandidates.h)
 *         on one thread:   collapse them, smallest ratio first, where no earlier collapse of the
 *                          round changed anything
 *     rounds until one removes little
 *
 * Edges at open boundaries and constrained parts are left to the sweep.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_SlackCollapse_h
#define BoneDecimate_Core_Decimate_Stages_SlackCollapse_h

#include "Decimate/Edit/Editor.h"
#include "SlackCandidates.h"
#include "SlackFit.h"

#include <vector>

namespace bonedecimate
{
class SlackCollapse
{
public:
  /// @param editor Must keep quadrics, and they must be up to date.
  SlackCollapse(Editor& editor, Samples& samples, OriginalHints& hints, int threads);

  /// Collapses down to that many faces at most. False if the monitor requests a stop.
  bool Run(Index faces, const Monitor& monitor);

private:
  bool Collapse(const SlackCandidate& candidate);
  bool IsTouched(const EdgeNeighborhood& around) const;

  Editor& MeshEditor;
  Samples& OriginalSamples;
  OriginalHints& Hints;
  SlackCandidates Candidates;
  SlackFit Slack;
  EditWorkspace Workspace;
  std::vector<char> TouchedVertices; // for each vertex, in this round
};
}

#endif
