// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockSweep.h
 * @brief Collapses what is cheap within one block of consecutive vertices, level by level.
 *
 *     list the vertices by level, eight an octave
 *     while there is a level not above the limit, and collapses are left:
 *         for every vertex of the lowest level:
 *             judge its edges afresh, cheapest first
 *             dearer than the level:      that is its key from now on, and it goes to that level
 *             reaches out of the block:   put off to the next pass, whose blocks lie otherwise
 *             leaves too much behind:     as if refused (its peak alone would be dearer than the level)
 *             refused by the gate:        the next edge; after the last, its key goes up by four octaves
 *             else collapse; the merged vertex gets a key and goes to its level
 *
 * Neighbours keep their keys although their costs changed: they are judged afresh when their turn comes. In small
 * meshes that is not good enough, and they get new keys at once. No vertex outside the block is read or written, so
 * that blocks may be swept at the same time.
 */
#ifndef BoneDecimate_Core_Collapse_BlockSweep_h
#define BoneDecimate_Core_Collapse_BlockSweep_h

#include "Editor.h"
#include "Goal.h"
#include "VertexEdges.h"

#include <array>
#include <vector>

namespace bonedecimate
{
struct BlockTask
{
  VertexRange Vertices;
  CostKey Limit = NeverKey - 1; ///< Dearer ones stay.
  Index Collapses = 0;          ///< The most allowed.
  int Workers = 1;              ///< Blocks that are swept at the same time.
  bool RenewsRing = false;      ///< New keys for the ring of each merged vertex.
  /// Of a merged vertex, until one can be proved: one is the best alone, and no other edge is tried instead.
  int Places = 1;
  static constexpr int MostPlaces = 13;
  bool TriesAll() const { return this->Places > 1; }
};

class BlockSweep
{
public:
  BlockSweep(Editor& editor, VertexKeys& keys)
    : Work(editor)
    , Known(keys)
    , Compute(BestKernels())
  {
  }

  /// New keys for the vertices from first to last, whatever block their neighbours lie in.
  void RenewAll(Index first, Index last);

  /// @param goOn Asked after every collapse.
  /// @param pulse Asked before every vertex that is looked at.
  template <typename GoOn, typename Pulse>
  void Run(const BlockTask& task, const GoOn& goOn, const Pulse& pulse);

  /// What the edits since the last time amount to, for Editor::Settle.
  Tally& Counted() { return this->Space.Counted; }

private:
  enum class Outcome
  {
    Dearer,
    Crossing, ///< As long as nothing near it changes.
    TooFar,   ///< Until something around it changes.
    Collapsed,
    Elsewhere
  };
  void Renew(Index vertex);
  VertexEdges& EdgesOfReady(std::size_t at, CostKey highest);
  Outcome CollapseAt(VertexEdges& edges, CostKey highest);
  bool WasTried(Index vertex) const;
  Outcome TryEdge(Index vertex, const VertexEdges::Candidate& candidate, float mostCost);
  double LeaveBehind(const Edit& edit);
  double CostOfPeak(double distance) const;
  Edit EditOf(Index vertex, const VertexEdges::Candidate& candidate) const;
  Outcome ApplyWherever(const Edit& best, float mostCost);
  void AfterCollapse(const Edit& edit, Index gone);
  void ForgetChanged();
  bool IsInside(Index v) const { return this->Task.Vertices.Contains(v); }
  void LookAhead(std::size_t at);
  void ListVertices();
  void SetKey(Index vertex, CostKey key);
  void PutOff(Index vertex);
  void Restore();

  Editor& Work;
  VertexKeys& Known;
  const Kernels& Compute;
  BlockTask Task;
  Workspace Space;
  VertexEdges Gathered[2]; // of one vertex and the next
  VertexEdges Merged;
  std::vector<Index> Ready;
  static constexpr std::size_t Ahead = 8; // vertices
  std::array<Index, Ahead> Cursors{};     // half-edges at the next vertices of Ready
  LevelLists Levels;
  struct OldKey
  {
    Index Vertex;
    CostKey Key;
  };
  std::vector<OldKey> Postponed;
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
    const CostKey highest = std::min(this->Levels.TakeLowest(this->Ready), task.Limit);
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
      if (this->Known.Keys[this->Ready[i]] <= highest &&
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
