// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorQueue.h
 * @brief Collapses edges of a block of vertices in the order of their change of the sampled error
 * in both directions.
 *
 *     take the cheapest edge
 *     its surroundings have changed since its evaluation:   evaluate it again, put it back
 *     its ring leaves the block:                            add it to the remaining edges
 *     otherwise:   collapse it, pass its samples to the faces of the fan, and evaluate the edges
 *                  of the merged vertex
 *
 * A vertex whose ring leaves its block is never merged or moved. So no other worker changes
 * anything around an edge with both ends in the block, and blocks may be processed in parallel.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_ErrorQueue_h
#define BoneDecimate_Core_Decimate_Stages_ErrorQueue_h

#include "EdgeOrder.h"
#include "FanFit.h"
#include "SampledErrors.h"

#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

namespace bonedecimate
{
/// An edge and the cost of its collapse.
struct EvaluatedEdge
{
  double Cost = 0.0; // error after - error before, squares of the mesh's unit
  Index Edge = None;
  Index Start = None;
  Index End = None;
  std::uint32_t Stamp = 0;
  Vector3 Position = Vector3::Zero(); // mm from the local origin

  /// Puts the cheapest edge on top of a queue; equal ones by id.
  bool operator<(const EvaluatedEdge& other) const
  {
    return this->Cost != other.Cost ? this->Cost > other.Cost : this->Edge > other.Edge;
  }
};

/// Vertices [First, End), and limits for their collapses.
struct ErrorBlock
{
  Index First = 0;
  Index End = std::numeric_limits<Index>::max();
  double Limit = Infinity;     // cost above which an edge is left over
  float MaxQuadricCost = 0.0F; // by quadrics; edges above it are not evaluated
  int Workers = 1;             // that work at the same time

  bool Contains(VertexId v) const { return v >= this->First && v < this->End; }
};

class ErrorQueue
{
public:
  ErrorQueue(Editor& editor, Samples& samples, OriginalHints& hints, SampledErrors& errors,
    const ErrorBlock& block);

  /// Evaluates the edge. False if it cannot be collapsed.
  bool Evaluate(const RatedEdge& edge, EvaluatedEdge& evaluated);

  void Add(const EvaluatedEdge& edge) { this->Queue.push(edge); }

  /// @param beforeEdge Called with the number of collapses so far. Returns whether to continue.
  template <typename BeforeEdge>
  void Run(const BeforeEdge& beforeEdge);

  /// Evaluated edges that are not collapsed in this block.
  const std::vector<EvaluatedEdge>& RemainingEdges() const { return this->Remaining; }
  /// Counts of the collapses, for Editor::Settle.
  Tally& Counts() { return this->Workspace.Counts; }

private:
  void Take(const EvaluatedEdge& edge);
  void Push(const RatedEdge& edge);
  bool Collapse(const EvaluatedEdge& edge);

  Editor& MeshEditor;
  Samples& OriginalSamples;
  OriginalHints& Hints;
  SampledErrors& Errors;
  ErrorBlock Block;
  FanFit Fan;
  EditWorkspace Workspace;
  std::priority_queue<EvaluatedEdge> Queue;
  std::vector<EvaluatedEdge> Remaining;
  std::vector<RatedEdge> Candidates;
  std::int64_t Collapses = 0;
};

template <typename BeforeEdge>
void ErrorQueue::Run(const BeforeEdge& beforeEdge)
{
  while (!this->Queue.empty() && beforeEdge(this->Collapses))
  {
    const EvaluatedEdge edge = this->Queue.top();
    this->Queue.pop();
    this->Take(edge);
  }
  for (; !this->Queue.empty(); this->Queue.pop())
  {
    this->Remaining.push_back(this->Queue.top());
  }
}
}

#endif
