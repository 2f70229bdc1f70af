// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ForcedCollapse.h
 * @brief Collapses that exceed the error bound at first, together with moves around them that keep
 * it (PatchFit.h).
 *
 *     a round:   evaluate the edges near changes: those whose largest ratio is at most a given one
 *       (SlackCandidates.h)
 *                choose candidates without a common neighborhood, the least ratio first
 *                in parallel:     find moves that keep the bound, on copies            (PatchFit.h)
 *                on one thread:   apply what was found, each collapse with its moves as one proved
 *                  edit   (Editor::Try)
 *     rounds until no candidate is left
 *
 * A candidate that fails is tried again only when something near it has changed.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_ForcedCollapse_h
#define BoneDecimate_Core_Decimate_Stages_ForcedCollapse_h

#include "Decimate/Edit/Editor.h"
#include "PatchFit.h"
#include "SlackCandidates.h"

#include <vector>

namespace bonedecimate
{
struct ForcedReach
{
  double MaxRatio; ///< The largest ratio of a candidate.
  int Rings;       ///< Rings of vertices around it that may move.
};

class ForcedCollapse
{
public:
  /// @param editor Must keep quadrics, and they must be right.
  ForcedCollapse(
    Editor& editor, Samples& samples, OriginalHints& hints, ForcedReach reach, int threads);

  /// Down to that many faces at most. False if the monitor requests a stop.
  bool Run(Index faces, const Monitor& monitor);
  const ForcedCollapseFigures& Report() const { return this->Figures; }

private:
  struct Trial
  {
    SlackCandidate Candidate;
    std::vector<Index> Vertices = {}; // that the edit may read
    PatchFit::Result Fit = {};
  };
  void DropChanged();
  std::vector<Trial> Choose();
  bool Gather(const SlackCandidate& candidate, std::vector<Index>& vertices);
  bool TryAll(std::vector<Trial>& trials, const Monitor& monitor);
  bool Apply(const Trial& trial);

  Editor& MeshEditor;
  Samples& OriginalSamples;
  OriginalHints& Hints;
  SlackCandidates Candidates;
  ForcedReach Reach;
  int Threads;
  ForcedCollapseFigures Figures;
  EditWorkspace Workspace;
  std::vector<SlackCandidate> WaitingCandidates;
  std::vector<char> IsTaken; // of each vertex, in this round
};
}

#endif
