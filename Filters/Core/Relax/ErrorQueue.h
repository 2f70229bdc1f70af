// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorQueue.h
 * @brief Collapses edges of a block of vertices in the order of what that does to the sampled two-sided error.
 *
 *     take the cheapest edge
 *     something around it changed since it was judged:   judge it afresh, put it back
 *     its ring reaches out of the block:                 left over
 *     else:   collapse it, hand its samples to the faces of the fan, judge the edges of the merged vertex
 *
 * A vertex whose ring reaches out of its block is never merged or moved. So whatever is read around an edge with both
 * ends in a block is changed by nobody else, and blocks may be worked on at the same time.
 */
#ifndef BoneDecimate_Core_Relax_ErrorQueue_h
#define BoneDecimate_Core_Relax_ErrorQueue_h

#include "EdgeOrder.h"
#include "FanFit.h"
#include "SampledErrors.h"

#include <limits>
#include <queue>
#include <vector>

namespace bonedecimate
{
/// An edge with what its collapse would cost.
struct JudgedEdge
{
  double Cost = 0.0; // error after - error before, squares of the mesh's unit
  Index Edge = None;
  Index Start = None;
  Index End = None;
  std::uint32_t Stamp = 0;
  Vector3 Place = Vector3::Zero(); // mm from the local origin

  /// A queue has the cheapest on top, then the least edge.
  bool operator<(const JudgedEdge& other) const
  {
    return this->Cost != other.Cost ? this->Cost > other.Cost : this->Edge > other.Edge;
  }
};

/// Vertices [First, Last), and what may be done there.
struct ErrorBlock
{
  Index First = 0;
  Index Last = std::numeric_limits<Index>::max();
  double Limit = std::numeric_limits<double>::infinity(); // cost above which an edge is left over
  float Dearest = 0.0F; // by quadrics; dearer edges are not judged
  int Workers = 1;      // that work at the same time

  bool Holds(Index v) const { return v >= this->First && v < this->Last; }
};

class ErrorQueue
{
public:
  ErrorQueue(Editor& editor, Samples& samples, BackHints& hints, SampledErrors& errors,
    const ErrorBlock& block);

  /// False if the edge may not be collapsed.
  bool Judge(const RatedEdge& edge, JudgedEdge& judged);

  void Add(const JudgedEdge& edge) { this->Queue.push(edge); }

  /// @param goOn Asked with the number of collapses so far, before each edge; false ends it.
  template <typename GoOn>
  void Run(const GoOn& goOn);

  /// Judged, but not for this block.
  const std::vector<JudgedEdge>& LeftOver() const { return this->Left; }
  /// What the collapses amount to, for Editor::Settle.
  Tally& Counted() { return this->Space.Counted; }

private:
  void Take(const JudgedEdge& edge);
  void Push(const RatedEdge& edge);
  bool Collapse(const JudgedEdge& edge);
  void HandOver(const Neighbourhood& around);

  Editor& Work;
  Samples& Fit;
  BackHints& Back;
  SampledErrors& Errors;
  ErrorBlock Block;
  FanFit Costs;
  Workspace Space;
  std::priority_queue<JudgedEdge> Queue;
  std::vector<JudgedEdge> Left;
  std::vector<RatedEdge> Candidates;
  std::int64_t Collapses = 0;
};

template <typename GoOn>
void ErrorQueue::Run(const GoOn& goOn)
{
  while (!this->Queue.empty() && goOn(this->Collapses))
  {
    const JudgedEdge edge = this->Queue.top();
    this->Queue.pop();
    this->Take(edge);
  }
  for (; !this->Queue.empty(); this->Queue.pop())
  {
    this->Left.push_back(this->Queue.top());
  }
}
}

#endif
