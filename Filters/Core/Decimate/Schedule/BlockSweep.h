// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockSweep.h
 * @brief Collapses cheap edges within one block of consecutive vertices, list by list.
 *
 *     list the vertices by bucket, eight lists per factor of two                      (VertexLists)
 *     while a list is not above the limit, and collapses are left:
 *         for every vertex of the lowest list:
 *             evaluate its edges again
 *             cost above the list:        set the bucket of the vertex, and add it to the list of
 *                                         that bucket
 *             search the cheapest collapse that is accepted                        (CollapseSearch)
 *             deferred:                   to the next pass, which has other blocks
 *             rejected:                   set the bucket that the search found
 *             accepted:   collapse; compute the bucket of the merged vertex, and add it to its list
 *
 * No vertex outside the block is read or written, so that blocks may be swept in parallel.
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_BlockSweep_h
#define BoneDecimate_Core_Decimate_Schedule_BlockSweep_h

#include "VertexLists.h"

#include <array>
#include <vector>

namespace bonedecimate
{
class BlockSweep
{
public:
  BlockSweep(Editor& editor, const EdgeEvaluator& evaluate, VertexBuckets& buckets)
    : MeshEditor(editor)
    , Evaluate(evaluate)
    , Known(buckets)
    , Lists(editor.Mesh(), evaluate, buckets)
    , Search(editor, buckets)
  {
  }

  /// Computes the buckets of the vertices from first to last, whatever block their neighbors lie
  /// in.
  void RenewAll(Index first, Index last);

  /// @param goOn Called after every collapse.
  /// @param pulse Called before every vertex; both return whether the sweep continues.
  template <typename GoOn, typename Pulse>
  void Run(const BlockTask& task, const GoOn& goOn, const Pulse& pulse);

  /// Totals of the edits since the last call, for Editor::Settle.
  Tally& Counted() { return this->Space.Counted; }

private:
  VertexEdges& EdgesOfReady(std::size_t at, CostBucket highest);
  bool CollapseAt(VertexEdges& edges, CostBucket highest);
  void ForgetChanged();
  void LookAhead(std::size_t at);
  void Defer(VertexId vertex);
  void Restore();

  Editor& MeshEditor;
  const EdgeEvaluator& Evaluate;
  VertexBuckets& Known;
  BlockTask Task;
  VertexLists Lists;
  CollapseSearch Search;
  Workspace Space;
  VertexEdges Gathered[2]; // of one vertex and the next
  std::vector<Index> Ready;
  static constexpr std::size_t Ahead = 8; // vertices
  std::array<Index, Ahead> Cursors{};     // half-edges at the next vertices of Ready
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
  this->Space.Change.Range = task.Vertices;
  this->Space.Change.Workers = task.Workers;
  this->Lists.Fill(task);
  Index left = task.Collapses;
  while (left > 0)
  {
    const CostBucket highest = this->Lists.TakeLowest(this->Ready);
    if (this->Ready.empty())
    {
      break;
    }
    this->Cursors.fill(None);
    this->Space.Change.Rank = highest;
    for (std::size_t i = 0; i < this->Ready.size() && left > 0; ++i)
    {
      if (!pulse())
      {
        left = 0;
        break;
      }
      this->LookAhead(i);
      if (this->Known.Buckets[this->Ready[i]] <= highest &&
        this->CollapseAt(this->EdgesOfReady(i, highest), highest))
      {
        left = goOn() ? left - 1 : 0;
      }
    }
  }
  this->Restore();
}
}

#endif
