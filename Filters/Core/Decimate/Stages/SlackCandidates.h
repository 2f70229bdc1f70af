// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlackCandidates.h
 * @brief Edges whose collapse keeps the error bound, or exceeds it by little, after the merged
 * vertex has moved to the best position.
 *
 *     start:   the position by quadrics, the middle or an end, whichever is nearest to the
 *              samples of the original (SlackFit.h); edges that are too far there are left out
 *     moves:   by the samples, then by samples and points on the faces
 *
 * Only edges near changes are evaluated. Edges at open boundaries and constrained parts are left
 * out.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_SlackCandidates_h
#define BoneDecimate_Core_Decimate_Stages_SlackCandidates_h

#include "Decimate/Edit/Editor.h"
#include "EdgeOrder.h"
#include "SlackFit.h"

#include <vector>

namespace bonedecimate
{
struct SlackCandidate
{
  double Ratio = 0.0; ///< Largest ratio of a distance to its limit.
  Index Edge = None;
  Index Start = None;
  Index End = None;
  Vector3 Position = Vector3::Zero(); ///< mm from the local origin
  Index Hint = None;

  bool operator<(const SlackCandidate& other) const
  {
    return this->Ratio != other.Ratio ? this->Ratio < other.Ratio : this->Edge < other.Edge;
  }
};

class SlackCandidates
{
public:
  /// @param editor Must keep quadrics, and they must be up to date.
  /// @param maxRatio Maximum ratio of a candidate.
  SlackCandidates(const Editor& editor, const Samples& samples, const OriginalHints& hints,
    double maxRatio, int threads);

  /// Appends candidates near changes since the last call, at first all. False if the monitor
  /// requests a stop.
  bool Find(const Monitor& monitor, std::vector<SlackCandidate>& candidates);

  void NoteChange(VertexId vertex) { this->Changed[vertex] = 1; }
  bool IsChanged(VertexId vertex) const { return this->Changed[vertex] != 0; }

  /// Builds the fan of the merged vertex, with the samples of all faces at the edge.
  static void Gather(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, SlackFit& slack);

private:
  /// Evaluates edges on one thread.
  struct Evaluator
  {
    SlackFit Slack;
    EditWorkspace Workspace;
    std::vector<RatedEdge> Edges;
  };
  void EvaluateAt(VertexId vertex, Evaluator& evaluator, std::vector<SlackCandidate>& found) const;
  bool EvaluateEdge(const RatedEdge& edge, Evaluator& evaluator, SlackCandidate& candidate) const;

  const Editor& MeshEditor;
  const Samples& OriginalSamples;
  const OriginalHints& Hints;
  double MaxRatio;
  int Threads;
  std::vector<char> Changed; // for each vertex, since its edges were evaluated
};
}

#endif
