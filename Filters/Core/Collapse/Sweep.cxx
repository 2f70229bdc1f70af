// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sweep.h"

#include "Mesh/MeanEdgeLength.h"
#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr Index VerticesOfBlock = 4096; // that are still there, on average
constexpr Index RenewBelowShare = 50;
constexpr Index LeastForRounds = 8 * VerticesOfBlock;

/// Costs are proportional to length^3.5.
float CostFactorOf(const HalfEdgeMesh& mesh)
{
  const double lengths = MeanEdgeLength(mesh) / mesh.Unit();
  return lengths > 0.0
    ? static_cast<float>(1.0 / (lengths * lengths * lengths * std::sqrt(lengths)))
    : 1.0F;
}
}

Sweep::Sweep(Editor& editor, const Stops& stops, int threads)
  : Work(editor)
  , Wanted(stops)
  , End(editor, stops)
  , Threads(editor.HasHook() ? 1 : threads)
  , FacesAtFirst(editor.Mesh().NumberOfFaces())
{
  const std::size_t count = static_cast<std::size_t>(editor.Mesh().NumberOfVertexSlots());
  this->Known.Keys.assign(count, NeverKey);
  this->Known.Memories.assign(count, 0.0F);
  this->Known.CostFactor = CostFactorOf(editor.Mesh());
}

//------------------------------------------------------------------------------
StopReason Sweep::Run(const Monitor& monitor)
{
  std::int64_t editsWhenRenewed = -1;
  while (!this->End.IsReached())
  {
    if (this->Work.NumberOfEdits() == editsWhenRenewed)
    {
      return StopReason::NothingLeft;
    }
    editsWhenRenewed = this->Work.NumberOfEdits();
    if (!this->RenewAll(monitor))
    {
      return StopReason::Aborted;
    }
    while (this->Wanted.Error == 0.0 && this->CollapsesWanted() > this->FacesAtFirst / 64 &&
      this->Work.Mesh().NumberOfVertexSlots() > LeastForRounds)
    {
      const Index wanted = this->CollapsesWanted();
      if (!this->Round(monitor))
      {
        return StopReason::Aborted;
      }
      if (wanted - this->CollapsesWanted() < wanted / 16)
      {
        break;
      }
    }
    if (!this->Tail(monitor))
    {
      return StopReason::Aborted;
    }
  }
  return this->End.Reason();
}

//------------------------------------------------------------------------------
bool Sweep::RenewAll(const Monitor& monitor)
{
  return ForEachChunk(
    this->Known.Keys.size(), this->Threads, [&](double) { return this->End.Tell(monitor); },
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      BlockSweep(this->Work, this->Known)
        .RenewAll(static_cast<Index>(first), static_cast<Index>(last));
    });
}

//------------------------------------------------------------------------------
/// Each takes two faces, but for the few on borders.
Index Sweep::CollapsesWanted() const
{
  return std::max(0, this->Work.Mesh().NumberOfFaces() - this->Wanted.Faces) / 2;
}

//------------------------------------------------------------------------------
/// False if the monitor stopped it.
bool Sweep::Round(const Monitor& monitor)
{
  const std::vector<BlockTask> blocks = this->Blocks(this->LimitFor(this->CollapsesWanted()));
  std::vector<Tally> counted(blocks.size());
  const bool done = ForEachChunk(
    blocks.size(), this->Threads, [&](double) { return this->End.Tell(monitor); },
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      BlockSweep block(this->Work, this->Known);
      for (std::size_t i = first; i < last; ++i)
      {
        block.Run(blocks[i], [] { return true; });
        counted[i] = std::exchange(block.Counted(), {});
      }
    });
  for (Tally& tally : counted)
  {
    this->Work.Settle(tally);
  }
  ++this->Rounds;
  return done;
}

//------------------------------------------------------------------------------
/// The highest key such that no more than that many are not above it.
int Sweep::LimitFor(Index collapses) const
{
  std::vector<Index> histogram(NeverKey + 1, 0);
  for (const CostKey key : this->Known.Keys)
  {
    ++histogram[key];
  }
  Index sum = 0;
  int limit = 0;
  while (limit < NeverKey && sum + histogram[static_cast<std::size_t>(limit)] <= collapses)
  {
    sum += histogram[static_cast<std::size_t>(limit++)];
  }
  return limit - 1;
}

//------------------------------------------------------------------------------
/// In vertex slots: the fewer are still there, the longer the block.
Index Sweep::BlockSize() const
{
  const Index slots = this->Work.Mesh().NumberOfVertexSlots();
  const Index live = std::max(1, this->Work.Mesh().NumberOfFaces() / 2);
  return static_cast<Index>(
    std::min<std::int64_t>(slots, std::int64_t{ VerticesOfBlock } * slots / live));
}

//------------------------------------------------------------------------------
std::vector<BlockTask> Sweep::Blocks(int limit) const
{
  const Index slots = this->Work.Mesh().NumberOfVertexSlots();
  const Index size = this->BlockSize();
  std::vector<BlockTask> blocks;
  for (Index first = this->Rounds % 2 == 0 ? 0 : -size / 2; first < slots; first += size)
  {
    BlockTask task;
    task.First = std::max(0, first);
    task.Last = std::min(slots, first + size);
    task.Limit = limit;
    task.Collapses = static_cast<Index>(std::count_if(this->Known.Keys.begin() + task.First,
      this->Known.Keys.begin() + task.Last, [&](CostKey key) { return key <= limit; }));
    blocks.push_back(task);
  }
  for (BlockTask& task : blocks)
  {
    task.Workers = static_cast<int>(blocks.size());
  }
  return blocks;
}

//------------------------------------------------------------------------------
/// False if the monitor stopped it.
bool Sweep::Tail(const Monitor& monitor)
{
  BlockSweep whole(this->Work, this->Known);
  bool goesOn = true;
  BlockTask task;
  task.Last = this->Work.Mesh().NumberOfVertexSlots();
  task.Limit = NeverKey - 1;
  const Index renewBelow = this->FacesAtFirst / RenewBelowShare;
  for (const bool renewsRing : { false, true })
  {
    task.RenewsRing = renewsRing;
    const Index until = renewsRing ? 0 : renewBelow;
    task.Collapses = std::max(0, this->Work.Mesh().NumberOfFaces() - until);
    whole.Run(task,
      [&]
      {
        this->Work.Settle(whole.Counted());
        goesOn = this->End.Tell(monitor);
        return goesOn && !this->End.IsReached() && this->Work.Mesh().NumberOfFaces() > until;
      });
    if (!goesOn || this->End.IsReached())
    {
      break;
    }
  }
  this->Work.Settle(whole.Counted());
  return goesOn;
}
}
