// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BucketSweep.h"

#include "Base/Parallel.h"
#include "Decimate/Cost/QuadricDeviation.h"
#include "Decimate/Cost/SpikePenalty.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Live vertices of a block, on average. There are sixteen blocks, within these limits.
constexpr Index MinOfBlock = 2048;
constexpr Index MaxOfBlock = 16384;
/// Where edits are proved, smaller blocks pay off.
constexpr Index MinOfProvedBlock = 512;
constexpr Index RenewBelowDivisor = 50;
constexpr Index MinBlocksForRounds = 8;
/// Fraction of the remaining collapses that a round aims at, to stay below the final limit.
constexpr double RoundFraction = 0.7;
constexpr int FirstStep = 2 * BucketsPerDoubling; // first rise of the limit
/// Collapses between two reports of a sweep of the whole mesh: some milliseconds.
constexpr Index CollapsesPerReport = 1024;
/// Vertices between two reports where edits are proved.
constexpr Index VerticesPerReport = 64;
}

BucketSweep::BucketSweep(
  Editor& editor, int threads, const SweepSettings& settings, const SweepPolicies& policies)
  : MeshEditor(editor)
  , End(editor, {})
  , Threads(editor.HasHook() ? 1 : threads)
  , InitialFaces(editor.Mesh().NumberOfFaces())
  , PositionsTried(
      editor.Bound() != nullptr ? settings.PositionsTried : settings.PositionsTriedForVoxels)
  , Evaluate(policies)
{
  const std::size_t count = static_cast<std::size_t>(editor.Mesh().NumberOfVertexSlots());
  this->Data.Buckets.assign(count, NeverBucket);
  this->Data.AccumulatedErrors.assign(count, 0.0F);
  const double length = editor.Mesh().InitialEdgeLength() / editor.Mesh().Unit();
  this->Data.CostFactor = CostNormalization(length);
  // A proved bound needs no penalty.
  this->Data.SpikeFactor = editor.Bound() != nullptr
    ? 0.0
    : SpikeFactor(settings.SpikeWeight, this->InitialFaces, length, this->Data.CostFactor);
}

//------------------------------------------------------------------------------
StopReason BucketSweep::Run(const StopTargets& stops, const Monitor& monitor)
{
  this->Targets = stops;
  this->End.Restart(stops);
  for (VertexId v = 0; v < this->MeshEditor.Mesh().NumberOfVertexSlots(); ++v)
  {
    this->Data.Buckets[v] =
      this->MeshEditor.Mesh().Outgoing(v) == None ? NeverBucket : this->Data.Buckets[v];
  }
  if (this->MeshEditor.LimitsEdits())
  {
    return this->RunProved(monitor);
  }
  std::int64_t editsWhenRenewed = -1;
  while (!this->End.IsReached())
  {
    if (this->MeshEditor.Totals().Collapses == editsWhenRenewed)
    {
      return StopReason::NothingLeft;
    }
    editsWhenRenewed = this->MeshEditor.Totals().Collapses;
    if (!this->RenewAll(monitor))
    {
      return StopReason::Aborted;
    }
    if (!this->RunRounds(monitor) || !this->Tail(monitor))
    {
      return StopReason::Aborted;
    }
  }
  return this->End.Reason();
}

//------------------------------------------------------------------------------
bool BucketSweep::HasRounds() const
{
  const Index least = this->MeshEditor.LimitsEdits() ? MinOfProvedBlock : MinOfBlock;
  return this->MeshEditor.Mesh().NumberOfVertexSlots() >= MinBlocksForRounds * least;
}

//------------------------------------------------------------------------------
/// Runs rounds while many collapses remain. False if the monitor requests a stop.
bool BucketSweep::RunRounds(const Monitor& monitor)
{
  if (!this->HasRounds())
  {
    return true;
  }
  CostBucket limit = this->FirstLimit(this->RemainingCollapses());
  int step = FirstStep;
  bool goesUp = true;
  for (int round = 0; goesUp && this->RemainingCollapses() > this->InitialFaces / 128; ++round)
  {
    const Index wanted = this->RemainingCollapses();
    if (!this->Round(limit, monitor))
    {
      return false;
    }
    const Index left = this->RemainingCollapses();
    if (round > 0)
    {
      const double perBucket = std::max(1, wanted - left) / static_cast<double>(step);
      step = static_cast<int>(std::clamp<double>(RoundFraction * left / perBucket, 1.0, MaxStep));
    }
    goesUp = limit < LastBucket; // nothing above it can be collapsed
    limit = Raised(limit, step);
  }
  return true;
}

//------------------------------------------------------------------------------
bool BucketSweep::RenewAll(const Monitor& monitor)
{
  return ForEachChunk(
    this->Data.Buckets.size(), this->Threads, [&](double) { return this->End.ReportNow(monitor); },
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      BlockSweep(this->MeshEditor, this->Evaluate, this->Data)
        .RenewAll(static_cast<Index>(first), static_cast<Index>(last));
    });
}

//------------------------------------------------------------------------------
/// Each collapse removes two faces, except for the few on boundaries.
Index BucketSweep::RemainingCollapses() const
{
  return std::max(0, this->MeshEditor.Mesh().NumberOfFaces() - this->Targets.Faces) / 2;
}

//------------------------------------------------------------------------------
/// The highest bucket with no more than that many vertices up to it.
CostBucket BucketSweep::FirstLimit(Index collapses) const
{
  std::vector<Index> histogram(NeverBucket + 1, 0);
  for (const CostBucket bucket : this->Data.Buckets)
  {
    ++histogram[bucket];
  }
  Index left = collapses;
  std::size_t limit = 0;
  while (limit < NeverBucket && histogram[limit] <= left)
  {
    left -= histogram[limit++];
  }
  return static_cast<CostBucket>(limit > 0 ? limit - 1 : 0);
}

//------------------------------------------------------------------------------
/// Sweeps blocks, shifted blocks, and the whole mesh for the edges between them. False if the
/// monitor requests a stop.
bool BucketSweep::Round(CostBucket limit, const Monitor& monitor)
{
  return this->SweepBlocks(limit, { this->BlockSize(), false }, monitor) &&
    this->SweepBlocks(limit, { this->BlockSize(), true }, monitor) &&
    (!this->MeshEditor.LimitsEdits() || this->SweepBlocks(limit, this->LargeBlocks(), monitor)) &&
    this->SweepWhole(limit, this->Targets.Faces, false, monitor);
}

//------------------------------------------------------------------------------
/// Sweeps blocks in parallel. False if the monitor requests a stop.
bool BucketSweep::SweepBlocks(CostBucket limit, BlockCut cut, const Monitor& monitor)
{
  const std::vector<BlockTask> blocks = this->Blocks(limit, cut);
  std::vector<Tally> counted(blocks.size());
  std::atomic<Index> removed{ 0 };
  std::atomic<bool> shouldContinue{ true };
  const auto tell = [&]
  {
    shouldContinue = shouldContinue && this->End.ReportNow(monitor, removed);
    return shouldContinue.load();
  };
  const bool isSlow = this->MeshEditor.LimitsEdits();
  const std::thread::id teller = std::this_thread::get_id();
  const bool done = ForEachPart(
    blocks.size(), this->Threads, [&](double) { return tell(); },
    [&](std::size_t i)
    {
      const bool tells = std::this_thread::get_id() == teller;
      Index looked = 0;
      const auto beforeVertex = [&]
      {
        const bool isTime = isSlow && ++looked % VerticesPerReport == 0;
        return !isTime || (tells ? tell() : shouldContinue.load());
      };
      BlockSweep block(this->MeshEditor, this->Evaluate, this->Data);
      block.Run(
        blocks[i], [] { return true; }, beforeVertex);
      counted[i] = std::exchange(block.Counts(), {});
      removed += counted[i].RemovedFaces;
    });
  this->MeshEditor.Settle(counted.data(), counted.size());
  return done;
}

//------------------------------------------------------------------------------
/// In vertex slots: a block of a coarse mesh has more slots per live vertex.
Index BucketSweep::BlockSize() const
{
  const Index slots = this->MeshEditor.Mesh().NumberOfVertexSlots();
  const Index live = std::max(1, this->MeshEditor.Mesh().NumberOfFaces() / 2);
  const Index least = this->MeshEditor.LimitsEdits() ? MinOfProvedBlock : MinOfBlock;
  const std::int64_t wanted = std::clamp(live / 16, least, MaxOfBlock);
  return static_cast<Index>(std::min<std::int64_t>(slots, wanted * slots / live));
}

//------------------------------------------------------------------------------
/// Three blocks, for edges between small ones. Few edges lead out of so few blocks, and they do not
/// end where other blocks end.
BucketSweep::BlockCut BucketSweep::LargeBlocks() const
{
  return { 1 + 2 * (this->MeshEditor.Mesh().NumberOfVertexSlots() / 5), false };
}

//------------------------------------------------------------------------------
/// Each block may collapse in proportion to its vertices up to the limit.
std::vector<BlockTask> BucketSweep::Blocks(CostBucket limit, BlockCut cut) const
{
  const Index slots = this->MeshEditor.Mesh().NumberOfVertexSlots();
  std::vector<BlockTask> blocks;
  std::int64_t ready = 0;
  for (Index first = cut.IsShifted ? -cut.Size / 2 : 0; first < slots; first += cut.Size)
  {
    BlockTask task;
    task.Vertices = { std::max(0, first), std::min(slots, first + cut.Size) };
    task.Limit = limit;
    task.PositionsTried = this->TriesAll ? this->PositionsTried : 1;
    task.Collapses = CountUpTo(limit, this->Data.Buckets.data() + task.Vertices.First,
      this->Data.Buckets.data() + task.Vertices.End);
    ready += task.Collapses;
    blocks.push_back(task);
  }
  const std::int64_t wanted = this->RemainingCollapses();
  for (BlockTask& task : blocks)
  {
    task.Workers = static_cast<int>(blocks.size());
    task.Collapses =
      static_cast<Index>(task.Collapses * wanted / std::max<std::int64_t>(wanted, ready));
  }
  return blocks;
}

//------------------------------------------------------------------------------
/// The mesh as one block, down to that many faces.
BlockTask BucketSweep::WholeTask(CostBucket limit, Index faces) const
{
  BlockTask task;
  task.Vertices.End = this->MeshEditor.Mesh().NumberOfVertexSlots();
  task.Limit = limit;
  task.PositionsTried = this->TriesAll ? this->PositionsTried : 1;
  task.Collapses = std::max(0, this->MeshEditor.Mesh().NumberOfFaces() - faces);
  return task;
}

//------------------------------------------------------------------------------
/// False if the monitor requests a stop.
bool BucketSweep::Tail(const Monitor& monitor)
{
  const Index renewBelow = this->InitialFaces / RenewBelowDivisor;
  return this->SweepWhole(LastBucket, renewBelow, false, monitor) &&
    (this->End.IsReached() || this->SweepWhole(LastBucket, 0, true, monitor));
}

//------------------------------------------------------------------------------
/// Sweeps the mesh as one block, down to that many faces. False if the monitor requests a stop.
bool BucketSweep::SweepWhole(CostBucket limit, Index faces, bool renewsRing, const Monitor& monitor)
{
  BlockSweep whole(this->MeshEditor, this->Evaluate, this->Data);
  BlockTask task = this->WholeTask(limit, faces);
  task.RenewsRing = renewsRing;
  bool shouldContinue = true;
  Index collapses = 0;
  Index looked = 0;
  const auto afterCollapse = [&]
  {
    this->MeshEditor.Settle(&whole.Counts());
    const bool isTime = ++collapses % CollapsesPerReport == 0;
    shouldContinue = isTime ? this->End.ReportNow(monitor) : this->End.Report(monitor);
    return shouldContinue && !this->End.IsReached() &&
      this->MeshEditor.Mesh().NumberOfFaces() > faces;
  };
  const bool isSlow = this->MeshEditor.LimitsEdits();
  const auto beforeVertex = [&]
  {
    const bool isTime = isSlow && ++looked % VerticesPerReport == 0;
    shouldContinue = shouldContinue && (!isTime || this->End.ReportNow(monitor));
    return shouldContinue;
  };
  whole.Run(task, afterCollapse, beforeVertex);
  this->MeshEditor.Settle(&whole.Counts());
  return shouldContinue;
}
}
