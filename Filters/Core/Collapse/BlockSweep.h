// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockSweep.h
 * @brief Collapses what is cheap within one block of consecutive vertices, level by level.
 *
 *     level = least key of the block
 *     while level <= limit and collapses are left:
 *         for every vertex whose key is not above the level:
 *             judge its edges afresh, cheapest first
 *             dearer than the level:      that is its key from now on
 *             reaches out of the block:   its turn comes in another round
 *             refused by the gate:        the next edge; after the last, its key goes up by four octaves
 *             else collapse; the merged vertex gets a key
 *         level = an eighth of an octave higher, or the least key if that is above
 *
 * Neighbours keep their keys although their costs changed: they are judged afresh when their turn comes. In small
 * meshes that is not good enough, and they get new keys at once. No vertex outside the block is read or written, so that blocks may
 * be swept at the same time.
 */
#ifndef BoneDecimate_Core_Collapse_BlockSweep_h
#define BoneDecimate_Core_Collapse_BlockSweep_h

#include "Editor.h"
#include "Goal.h"

#include <vector>

namespace bonedecimate
{
/// The upper 16 bits below the sign of a cost: ordered like costs, 256 to an octave.
using CostKey = std::uint16_t;
constexpr CostKey NeverKey = 0xFFFF;
constexpr int KeysOfOctave = 256;

/// What a sweep knows of every vertex, beside the mesh.
struct VertexKeys
{
  std::vector<CostKey> Keys; ///< NeverKey: gone, locked, or nothing to collapse.
  std::vector<float>
    Memories; ///< Distance left behind so far by what was merged into it, units of the mesh.
  float CostFactor = 1.0F; ///< Makes costs independent of how the unit was rounded.
};

struct BlockTask
{
  Index First = 0; ///< Vertices [First, Last).
  Index Last = 0;
  int Limit = NeverKey;    ///< The highest level.
  Index Collapses = 0;     ///< The most allowed.
  int Workers = 1;         ///< Blocks that are swept at the same time.
  bool RenewsRing = false; ///< New keys for the ring of each merged vertex.
};

class BlockSweep
{
public:
  BlockSweep(Editor& editor, VertexKeys& keys)
    : Work(editor)
    , Known(keys)
    , Compute(BestKernels())
    , PerUnit(1.0 / editor.Mesh().Unit())
  {
  }

  /// New keys for the vertices from first to last, whatever block their neighbours lie in.
  void RenewAll(Index first, Index last);

  /// @param goOn Asked after every collapse.
  template <typename GoOn>
  void Run(const BlockTask& task, const GoOn& goOn);

  /// What the edits since the last time amount to, for Editor::Settle.
  Tally& Counted() { return this->Space.Counted; }

private:
  struct Candidate
  {
    float Cost = 0.0F;
    Index Edge = None;
    float Move[3] = {}; // from the vertex, units
  };
  enum class Outcome
  {
    Dearer,
    Collapsed,
    Elsewhere
  };
  void Renew(Index vertex);
  bool FindCandidates(Index vertex);
  void JudgeBatch();
  Outcome CollapseAt(Index vertex, int level);
  Outcome TryEdge(Index vertex, const Candidate& candidate);
  Edit EditOf(Index vertex, const Candidate& candidate) const;
  void AfterCollapse(const Edit& edit, Index gone);
  bool IsInside(Index v) const { return v >= this->Task.First && v < this->Task.Last; }
  int FindReady(int level);
  void PutOff(Index vertex);
  void Restore();

  Editor& Work;
  VertexKeys& Known;
  const Kernels& Compute;
  double PerUnit; // 1/mm
  BlockTask Task;
  Workspace Space;
  EdgeBatch Batch;
  Index BatchEdges[EdgeBatch::Size] = {};
  std::vector<Candidate> Candidates;
  std::vector<Index> Ready;
  struct OldKey
  {
    Index Vertex;
    CostKey Key;
  };
  std::vector<OldKey> Postponed;
};

template <typename GoOn>
void BlockSweep::Run(const BlockTask& task, const GoOn& goOn)
{
  this->Task = task;
  Index left = task.Collapses;
  int level = 0;
  while (left > 0)
  {
    const int next = this->FindReady(level);
    for (const Index vertex : this->Ready)
    {
      if (this->Known.Keys[vertex] > level || this->CollapseAt(vertex, level) != Outcome::Collapsed)
      {
        continue;
      }
      if (--left == 0 || !goOn())
      {
        this->Restore();
        return;
      }
    }
    if (this->Ready.empty() && (next > task.Limit || next == NeverKey))
    {
      break;
    }
    level = std::min(std::max(level + KeysOfOctave / 8, next), task.Limit);
  }
  this->Restore();
}
}

#endif
