// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockSweep.h
 * @brief Collapses cheap edges within one block of consecutive vertices, list by list.
 *
 *     list the vertices by bucket, eight lists per factor of two                 (VertexLists)
 *     while a list is not above the limit and collapses remain:
 *         for every vertex of the lowest list:
 *             evaluate its edges again
 *             cost above the list:   set the bucket of the vertex, and add it to that list
 *             search the cheapest accepted collapse                              (CollapseSearch)
 *             deferred:    left to the next pass, which has other blocks
 *             rejected:    set the bucket that the search found
 *             accepted:    collapse; compute the bucket of the merged vertex and list it
 *
 * No vertex outside of the block is read or written, so blocks may be swept in parallel.
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
  BlockSweep(Editor& editor, const EdgeEvaluator& evaluate, SweepData& data)
    : MeshEditor(editor)
    , Evaluate(evaluate)
    , Data(data)
    , Lists(editor.Mesh(), evaluate, data)
    , Search(editor, data)
  {
  }

  /// Computes the buckets of the vertices from first to last, whatever block their neighbors lie
  /// in.
  void RenewAll(Index first, Index last);

  /// @param afterCollapse Called after every collapse.  @param beforeVertex Called before every
  /// vertex. Both return whether the sweep continues.
  template <typename AfterCollapse, typename BeforeVertex>
  void Run(
    const BlockTask& task, const AfterCollapse& afterCollapse, const BeforeVertex& beforeVertex);

  /// Counts since the last call, for Editor::Settle.
  Tally& Counts() { return this->Workspace.Counts; }

private:
  VertexEdges& EvaluatedEdges(std::size_t at, CostBucket highest);
  bool CollapseAt(VertexEdges& edges, CostBucket highest);
  void ForgetChanged();
  void LookAhead(std::size_t at);
  void Defer(VertexId vertex);
  void Restore();

  Editor& MeshEditor;
  const EdgeEvaluator& Evaluate;
  SweepData& Data;
  BlockTask Task;
  VertexLists Lists;
  CollapseSearch Search;
  EditWorkspace Workspace;
  VertexEdges GatheredEdges[2]; // of the current vertex and the next one
  std::vector<Index> List;
  static constexpr std::size_t PrefetchDistance = 8; // vertices
  std::array<Index, PrefetchDistance> Cursors{};     // half-edges at the next vertices of List
  struct OldBucket
  {
    Index Vertex;
    CostBucket Bucket;
  };
  std::vector<OldBucket> DeferredVertices;
};

template <typename AfterCollapse, typename BeforeVertex>
void BlockSweep::Run(
  const BlockTask& task, const AfterCollapse& afterCollapse, const BeforeVertex& beforeVertex)
{
  this->Task = task;
  this->Workspace.Change.Range = task.Vertices;
  this->Workspace.Change.Workers = task.Workers;
  this->Lists.Fill(task);
  Index left = task.Collapses;
  while (left > 0)
  {
    const CostBucket highest = this->Lists.TakeLowest(this->List);
    if (this->List.empty())
    {
      break;
    }
    this->Cursors.fill(None);
    this->Workspace.Change.Rank = highest;
    for (std::size_t i = 0; i < this->List.size() && left > 0; ++i)
    {
      if (!beforeVertex())
      {
        left = 0;
        break;
      }
      this->LookAhead(i);
      if (this->Data.Buckets[this->List[i]] <= highest &&
        this->CollapseAt(this->EvaluatedEdges(i, highest), highest))
      {
        left = afterCollapse() ? left - 1 : 0;
      }
    }
  }
  this->Restore();
}
}

#endif
