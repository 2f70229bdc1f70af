// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockSweep.h
 * @brief Collapses cheap edges within one block of consecutive vertices, list by list.
 *
 *     list the vertices by bucket, eight lists per factor of two
 *     while a list is not above the limit, and collapses are left:
 *         for every vertex of the lowest list:
 *             evaluate its edges again, cheapest first
 *             cost above the list:        set the bucket of the vertex, and add it to the list of that bucket
 *             ring leaves the block:      defer to the next pass, which has other blocks
 *             spike penalty above list:   as if rejected
 *             rejected:                   the next edge; after the last, raise the bucket by a factor of 16 in cost
 *             not proved, or intersects:  after the last edge that is tried, wait for the next pass
 *             else collapse; compute the bucket of the merged vertex, and add it to its list
 *
 * Neighbors keep their buckets although their costs changed, because they are evaluated again when they are processed. When
 * few faces remain, that loses accuracy, so RenewsRing computes their buckets at once. No vertex outside the block is read or written,
 * so that blocks may be swept in parallel.
 */
#ifndef BoneDecimate_Core_Schedule_BlockSweep_h
#define BoneDecimate_Core_Schedule_BlockSweep_h

#include "Edit/Editor.h"
#include "StopCriterion.h"
#include "VertexEdges.h"

#include <array>
#include <vector>

namespace bonedecimate
{
struct BlockTask
{
  VertexRange Vertices;
  CostBucket Limit = NeverBucket - 1; ///< Vertices above it are not collapsed.
  Index Collapses = 0;                ///< The most allowed.
  int Workers = 1;                    ///< Blocks that are swept at the same time.
  bool RenewsRing = false; ///< Compute the buckets of the ring of each merged vertex again.
  /// Positions tried for a merged vertex until one can be proved. 1: only the best position, and no other edge.
  int PositionsTried = 1;
  bool TriesAll() const { return this->PositionsTried > 1; }
};

class BlockSweep
{
public:
  BlockSweep(Editor& editor, const EdgeEvaluator& evaluate, VertexBuckets& buckets)
    : MeshEditor(editor)
    , Evaluate(evaluate)
    , Known(buckets)
    , Compute(BestKernels())
  {
  }

  /// Computes the buckets of the vertices from first to last, whatever block their neighbors lie in.
  void RenewAll(Index first, Index last);

  /// @param goOn Called after every collapse.
  /// @param pulse Called before every vertex; both return whether the sweep continues.
  template <typename GoOn, typename Pulse>
  void Run(const BlockTask& task, const GoOn& goOn, const Pulse& pulse);

  /// Totals of the edits since the last call, for Editor::Settle.
  Tally& Counted() { return this->Space.Counted; }

private:
  enum class Outcome
  {
    TooCostly,
    Crossing, ///< Rejected by the intersection guard; waits for the next pass.
    TooFar,   ///< Not proved; waits until something around it changes.
    Collapsed,
    Deferred
  };
  void Renew(VertexId vertex);
  VertexEdges& EdgesOfReady(std::size_t at, CostBucket highest);
  Outcome CollapseAt(VertexEdges& edges, CostBucket highest);
  bool WasTried(VertexId vertex) const;
  Outcome TryEdge(VertexId vertex, const VertexEdges::Candidate& candidate, float mostCost);
  double AccumulatedErrorAfter(const Edit& edit);
  Edit EditOf(VertexId vertex, const VertexEdges::Candidate& candidate) const;
  Outcome ApplyAtPositions(const Edit& best, float mostCost);
  void AfterCollapse(const Edit& edit, VertexId gone);
  void ForgetChanged();
  bool IsInside(VertexId v) const { return this->Task.Vertices.Contains(v); }
  void LookAhead(std::size_t at);
  void ListVertices();
  void SetBucket(VertexId vertex, CostBucket bucket);
  void Defer(VertexId vertex);
  void Restore();

  Editor& MeshEditor;
  const EdgeEvaluator& Evaluate;
  VertexBuckets& Known;
  const Kernels& Compute;
  BlockTask Task;
  Workspace Space;
  VertexEdges Gathered[2]; // of one vertex and the next
  VertexEdges Merged;
  std::vector<Index> Ready;
  static constexpr std::size_t Ahead = 8; // vertices
  std::array<Index, Ahead> Cursors{};     // half-edges at the next vertices of Ready
  BucketLists Lists;
  struct OldBucket
  {
    Index Vertex;
    CostBucket Bucket;
  };
  std::vector<OldBucket> Postponed;
};

template <typename GoOn, typename Pulse>
void BlockSweep::Run(const BlockTask& task, const GoOn& goOn, const Pulse& pulse)
{
  this->Task = task;
  this->Space.Range = task.Vertices;
  this->ListVertices();
  Index left = task.Collapses;
  while (left > 0)
  {
    const CostBucket highest = std::min(this->Lists.TakeLowest(this->Ready), task.Limit);
    if (this->Ready.empty())
    {
      break;
    }
    this->Cursors.fill(None);
    this->Space.Rank = highest;
    for (std::size_t i = 0; i < this->Ready.size() && left > 0; ++i)
    {
      if (!pulse())
      {
        left = 0;
        break;
      }
      this->LookAhead(i);
      if (this->Known.Buckets[this->Ready[i]] <= highest &&
        this->CollapseAt(this->EdgesOfReady(i, highest), highest) == Outcome::Collapsed)
      {
        left = goOn() ? left - 1 : 0;
      }
    }
  }
  this->Restore();
}
}

#endif
