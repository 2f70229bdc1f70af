// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sweep.h"

#include "Parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Vertices of a block that are still there, on average: sixteen blocks, within limits.
constexpr Index LeastOfBlock = 2048;
constexpr Index MostOfBlock = 16384;
/// Proofs are worth more blocks.
constexpr Index LeastOfProvedBlock = 512;
constexpr Index RenewBelowShare = 50;
constexpr Index LeastForRounds = 8 * LeastOfBlock; // vertices
/// Of the collapses still wanted, what a round should come to: short of the final limit.
constexpr double ShareOfRound = 0.7;
constexpr int FirstStep = 2 * KeysOfOctave; // by which the limit is raised
constexpr int LargestStep = 4 * KeysOfOctave;
/// To the monitor, of a sweep of the whole mesh: some milliseconds.
constexpr Index CollapsesBetweenWords = 1024;
/// The same where edits are proved, in vertices that are looked at.
constexpr Index VerticesBetweenWords = 64;

constexpr CostKey LastKey = NeverKey - 1;
/// Where edits are proved: passes end that take away a smaller share of the faces than one by so many.
constexpr Index LeastOfPass = 128;

CostKey Raised(CostKey limit, int step)
{
  return static_cast<CostKey>(std::min<int>(limit + step, LastKey));
}

/// Costs are proportional to length^3.5.
float CostFactorOf(const HalfEdgeMesh& mesh)
{
  const double length = mesh.LengthAtFirst() / mesh.Unit();
  return static_cast<float>(1.0 / (length * length * length * std::sqrt(length)));
}

/**
 * Costs weigh distances by the area that moves. A peak, the tip of a thin spur, has no area: on the way to it everything
 * is cheap. So what a collapse leaves behind counts as if it moved an area that follows the mean face: the square of the
 * length at first, grown like the faces.
 */
double PeakFactorOf(const HalfEdgeMesh& mesh)
{
  const double length = mesh.LengthAtFirst() / mesh.Unit();
  return mesh.NumberOfFaces() * length * length * CostFactorOf(mesh);
}
}

Sweep::Sweep(Editor& editor, const Stops& stops, int threads, double peakWeight, int places)
  : Work(editor)
  , Wanted(stops)
  , End(editor, stops)
  , Threads(editor.HasHook() ? 1 : threads)
  , FacesAtFirst(editor.Mesh().NumberOfFaces())
  , Places(places)
{
  const std::size_t count = static_cast<std::size_t>(editor.Mesh().NumberOfVertexSlots());
  this->Known.Keys.assign(count, NeverKey);
  this->Known.Memories.assign(count, 0.0F);
  this->Known.CostFactor = CostFactorOf(editor.Mesh());
  // A proved limit needs no price for peaks.
  this->Known.PeakFactor = editor.IsGuaranteed() ? 0.0 : peakWeight * PeakFactorOf(editor.Mesh());
}

//------------------------------------------------------------------------------
StopReason Sweep::Run(const Monitor& monitor)
{
  if (this->Work.IsGuaranteed())
  {
    return this->RunProved(monitor);
  }
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
    if (!this->RunRounds(monitor) || !this->Tail(monitor))
    {
      return StopReason::Aborted;
    }
  }
  return this->End.Reason();
}

//------------------------------------------------------------------------------
StopReason Sweep::RunTo(const Stops& stops, const Monitor& monitor)
{
  this->Wanted = stops;
  this->End.Set(stops);
  for (Index v = 0; v < this->Work.Mesh().NumberOfVertexSlots(); ++v)
  {
    this->Known.Keys[v] = this->Work.Mesh().Outgoing(v) == None ? NeverKey : this->Known.Keys[v];
  }
  return this->Run(monitor);
}

//------------------------------------------------------------------------------
/// Nobody knows where it will end. What is refused is left until the next pass, which then tries it in every way.
StopReason Sweep::RunProved(const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  Index facesBefore = 0;
  for (int pass = 0; !this->End.IsReached(); ++pass)
  {
    if (pass > 1 && facesBefore - mesh.NumberOfFaces() <= facesBefore / LeastOfPass)
    {
      return this->Work.MetItsLimit() ? StopReason::ErrorReached : StopReason::NothingLeft;
    }
    facesBefore = mesh.NumberOfFaces();
    this->TriesAll = pass > 0;
    if (pass < 2)
    {
      this->Known.Changed.assign(this->Known.Keys.size(), 1);
    }
    if (!this->RenewAll(monitor) || !this->ProvedPass(monitor))
    {
      return StopReason::Aborted;
    }
  }
  return this->End.Reason();
}

//------------------------------------------------------------------------------
/// False if the monitor stopped it.
bool Sweep::ProvedPass(const Monitor& monitor)
{
  const Index half = this->Work.Mesh().NumberOfFaces() / 4; // of the vertices
  CostKey limit = this->HasRounds() && !this->TriesAll ? this->FirstLimit(half) : LastKey;
  bool goesOn = !this->HasRounds() || this->Round(limit, monitor);
  while (goesOn && limit < LastKey && !this->End.IsReached())
  {
    limit = Raised(limit, LargestStep);
    goesOn = this->Round(limit, monitor);
  }
  return goesOn &&
    (this->End.IsReached() || this->SweepWhole(LastKey, this->Wanted.Faces, false, monitor));
}

//------------------------------------------------------------------------------
bool Sweep::HasRounds() const
{
  return this->Work.Mesh().NumberOfVertexSlots() >= LeastForRounds;
}

//------------------------------------------------------------------------------
/// As long as they are worth it. False if the monitor stopped it.
bool Sweep::RunRounds(const Monitor& monitor)
{
  if (!this->HasRounds())
  {
    return true;
  }
  CostKey limit = this->FirstLimit(this->CollapsesWanted());
  int step = FirstStep;
  bool goesUp = true;
  for (int round = 0; goesUp && this->CollapsesWanted() > this->FacesAtFirst / 128; ++round)
  {
    const Index wanted = this->CollapsesWanted();
    if (!this->Round(limit, monitor))
    {
      return false;
    }
    const Index left = this->CollapsesWanted();
    if (round > 0)
    {
      const double perKey = std::max(1, wanted - left) / static_cast<double>(step);
      step = static_cast<int>(std::clamp<double>(ShareOfRound * left / perKey, 1.0, LargestStep));
    }
    goesUp = limit < LastKey; // what no limit lets through may not be collapsed at all
    limit = Raised(limit, step);
  }
  return true;
}

//------------------------------------------------------------------------------
bool Sweep::RenewAll(const Monitor& monitor)
{
  return ForEachChunk(
    this->Known.Keys.size(), this->Threads, [&](double) { return this->End.TellNow(monitor); },
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
/// The highest key such that no more vertices than that are not above it.
CostKey Sweep::FirstLimit(Index collapses) const
{
  std::vector<Index> histogram(NeverKey + 1, 0);
  for (const CostKey key : this->Known.Keys)
  {
    ++histogram[key];
  }
  Index left = collapses;
  std::size_t limit = 0;
  while (limit < NeverKey && histogram[limit] <= left)
  {
    left -= histogram[limit++];
  }
  return static_cast<CostKey>(limit > 0 ? limit - 1 : 0);
}

//------------------------------------------------------------------------------
/// Blocks, shifted blocks, and what neither can do. False if the monitor stopped it.
bool Sweep::Round(CostKey limit, const Monitor& monitor)
{
  return this->SweepBlocks(limit, { this->BlockSize(), false }, monitor) &&
    this->SweepBlocks(limit, { this->BlockSize(), true }, monitor) &&
    (!this->Work.IsGuaranteed() || this->SweepBlocks(limit, this->LargeBlocks(), monitor)) &&
    this->SweepWhole(limit, this->Wanted.Faces, false, monitor);
}

//------------------------------------------------------------------------------
/// Side by side. False if the monitor stopped it.
bool Sweep::SweepBlocks(CostKey limit, BlockCut cut, const Monitor& monitor)
{
  const std::vector<BlockTask> blocks = this->Blocks(limit, cut);
  std::vector<Tally> counted(blocks.size());
  std::atomic<Index> removed{ 0 };
  std::atomic<bool> goesOn{ true };
  const auto tell = [&]
  {
    goesOn = goesOn && this->End.TellNow(monitor, removed);
    return goesOn.load();
  };
  const bool isSlow = this->Work.IsGuaranteed();
  const std::thread::id teller = std::this_thread::get_id();
  const bool done = ForEachPart(
    blocks.size(), this->Threads, [&](double) { return tell(); },
    [&](std::size_t i)
    {
      const bool tells = std::this_thread::get_id() == teller;
      Index looked = 0;
      const auto pulse = [&]
      {
        const bool isTime = isSlow && ++looked % VerticesBetweenWords == 0;
        return !isTime || (tells ? tell() : goesOn.load());
      };
      BlockSweep block(this->Work, this->Known);
      block.Run(
        blocks[i], [] { return true; }, pulse);
      counted[i] = std::exchange(block.Counted(), {});
      removed += counted[i].RemovedFaces;
    });
  this->Work.Settle(counted);
  return done;
}

//------------------------------------------------------------------------------
/// In vertex slots: the fewer are still there, the longer the block.
Index Sweep::BlockSize() const
{
  const Index slots = this->Work.Mesh().NumberOfVertexSlots();
  const Index live = std::max(1, this->Work.Mesh().NumberOfFaces() / 2);
  const Index least = this->Work.IsGuaranteed() ? LeastOfProvedBlock : LeastOfBlock;
  const std::int64_t wanted = std::clamp(live / 16, least, MostOfBlock);
  return static_cast<Index>(std::min<std::int64_t>(slots, wanted * slots / live));
}

//------------------------------------------------------------------------------
/// For what reaches out of small ones: so few that little reaches out of them, with ends where no others have theirs.
Sweep::BlockCut Sweep::LargeBlocks() const
{
  return { 1 + 2 * (this->Work.Mesh().NumberOfVertexSlots() / 5), false };
}

//------------------------------------------------------------------------------
/// Each may collapse in proportion to the vertices it has below the limit.
std::vector<BlockTask> Sweep::Blocks(CostKey limit, BlockCut cut) const
{
  const Index slots = this->Work.Mesh().NumberOfVertexSlots();
  std::vector<BlockTask> blocks;
  std::int64_t ready = 0;
  for (Index first = cut.IsShifted ? -cut.Size / 2 : 0; first < slots; first += cut.Size)
  {
    BlockTask task;
    task.Vertices = { std::max(0, first), std::min(slots, first + cut.Size) };
    task.Limit = limit;
    task.Places = this->TriesAll ? this->Places : 1;
    task.Collapses = CountUpTo(limit, this->Known.Keys.data() + task.Vertices.First,
      this->Known.Keys.data() + task.Vertices.Last);
    ready += task.Collapses;
    blocks.push_back(task);
  }
  const std::int64_t wanted = this->CollapsesWanted();
  for (BlockTask& task : blocks)
  {
    task.Workers = static_cast<int>(blocks.size());
    task.Collapses =
      static_cast<Index>(task.Collapses * wanted / std::max<std::int64_t>(wanted, ready));
  }
  return blocks;
}

//------------------------------------------------------------------------------
/// False if the monitor stopped it.
bool Sweep::Tail(const Monitor& monitor)
{
  const Index renewBelow = this->FacesAtFirst / RenewBelowShare;
  return this->SweepWhole(LastKey, renewBelow, false, monitor) &&
    (this->End.IsReached() || this->SweepWhole(LastKey, 0, true, monitor));
}

//------------------------------------------------------------------------------
/// The mesh as one block, down to so many faces. False if the monitor stopped it.
bool Sweep::SweepWhole(CostKey limit, Index faces, bool renewsRing, const Monitor& monitor)
{
  BlockSweep whole(this->Work, this->Known);
  BlockTask task;
  task.Vertices.Last = this->Work.Mesh().NumberOfVertexSlots();
  task.Limit = limit;
  task.RenewsRing = renewsRing;
  task.Places = this->TriesAll ? this->Places : 1;
  task.Collapses = std::max(0, this->Work.Mesh().NumberOfFaces() - faces);
  bool goesOn = true;
  Index collapses = 0;
  Index looked = 0;
  const auto goOn = [&]
  {
    this->Work.Settle(whole.Counted());
    const bool isTime = ++collapses % CollapsesBetweenWords == 0;
    goesOn = isTime ? this->End.TellNow(monitor) : this->End.Tell(monitor);
    return goesOn && !this->End.IsReached() && this->Work.Mesh().NumberOfFaces() > faces;
  };
  const bool isSlow = this->Work.IsGuaranteed();
  const auto pulse = [&]
  {
    const bool isTime = isSlow && ++looked % VerticesBetweenWords == 0;
    goesOn = goesOn && (!isTime || this->End.TellNow(monitor));
    return goesOn;
  };
  whole.Run(task, goOn, pulse);
  this->Work.Settle(whole.Counted());
  return goesOn;
}
}
