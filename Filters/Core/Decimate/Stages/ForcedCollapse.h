// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ForcedCollapse.h
 * @brief Collapses that would exceed the error bound, together with moves and flips around them
 * that keep it (PatchFit.h).
 *
 *     a round:
 *         evaluate the edges near changes, up to a maximum ratio             (SlackCandidates)
 *         choose candidates without common neighborhoods, smallest ratio first
 *         in parallel:     find edits that keep the bound, on copies         (PatchFit)
 *         on one thread:   apply each collapse with its edits as one change  (Editor::Try)
 *     rounds until no candidate is left
 *
 * A candidate that fails is tried again only after something near it has changed.
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
  double MaxRatio; ///< Maximum ratio of a candidate.
  int Rings;       ///< Rings of vertices around the edge that may move.
};

class ForcedCollapse
{
public:
  /// @param editor Must keep quadrics, and they must be up to date.
  ForcedCollapse(
    Editor& editor, Samples& samples, OriginalHints& hints, ForcedReach reach, int threads);

  /// Collapses down to that many faces at most. False if the monitor requests a stop.
  bool Run(Index faces, const Monitor& monitor);
  const ForcedCollapseFigures& Report() const { return this->Figures; }

private:
  struct Trial
  {
    SlackCandidate Candidate;
    std::vector<Index> Vertices = {}; // those of all faces that may change
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
  std::vector<char> IsTaken; // for each vertex, in this round
};
}

#endif
