// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search.h"

#include "Base/Parallel.h"
#include "Frame.h"
#include "PieceSearch.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <thread>

namespace bonedecimate::certificate
{
namespace
{
/// Cuts for each simplex in the first round, and the factor from round to round.
constexpr std::int64_t FirstCuts = 32;
constexpr std::int64_t MoreCuts = 16;
/// Part of the progress of one search.
constexpr double ProgressOfFirstRound = 0.8;

/// For each point the first simplex with this corner; None if there is none.
std::vector<Index> FirstSimplices(const Simplices& source)
{
  std::vector<Index> first(source.Points.size(), None);
  for (std::size_t simplex = 0; simplex < source.Size(); ++simplex)
  {
    for (const Index corner : source.Corners[simplex])
    {
      if (corner != None && first[corner] == None)
      {
        first[corner] = static_cast<Index>(simplex);
      }
    }
  }
  return first;
}

/// The rounds; see Search.h.
class Rounds
{
public:
  Rounds(const Simplices& source, const Target& target, const PointValues& values,
    const SearchGoal& goal)
    : Source(source)
    , TargetSet(target)
    , Values(values)
    , Goal(goal)
    , OpenSimplices(source.Size())
  {
    std::iota(this->OpenSimplices.begin(), this->OpenSimplices.end(), 0);
  }

  DistanceBounds Run(
    const KnownBounds& known, const Monitor& monitor, const SearchListener& listener)
  {
    this->TakeCorners();
    this->TakeKnown(known);
    bool shouldContinue = true;
    double from = 0.0;
    double to = ProgressOfFirstRound;
    for (std::int64_t cuts = FirstCuts; shouldContinue && this->MayCut(); cuts *= MoreCuts)
    {
      shouldContinue = this->Round(cuts, PartOf(monitor, from, to), listener);
      from = to;
      to += 0.5 * (1.0 - to);
    }
    return this->Bounds();
  }

  /// The bounds of all simplices without a cut.
  DistanceBounds RunWithoutCuts()
  {
    this->TakeCorners();
    const std::vector<double> parts = this->UpperOfParts();
    this->MaxOpen = parts.empty() ? -Infinity : *std::max_element(parts.begin(), parts.end());
    return this->Bounds();
  }

private:
  struct Part
  {
    MaxExcess Max;
    double MaxClosed = -Infinity;
    double MaxOpen = -Infinity;
    std::int64_t Cuts = 0;
    std::vector<Index> OpenSimplices;
    std::vector<double> OpenUppers;
    std::atomic<bool> IsDone{ false };

    double Upper() const { return std::max(this->MaxClosed, this->MaxOpen); }
  };

  void TakeCorners()
  {
    for (std::size_t simplex = 0; simplex < this->Source.Size(); ++simplex)
    {
      const int count = this->Source.NumberOfCorners(simplex);
      for (int i = 0; i < count; ++i)
      {
        const Index point = this->Source.Corners[simplex][i];
        const double tolerance =
          this->Source.PointTolerance.empty() ? 0.0 : this->Source.PointTolerance[point];
        this->Max.Join({ this->Values.Value[point] - tolerance, tolerance,
          this->Source.Points[point], static_cast<Index>(simplex), this->Values.Simplex[point] });
      }
    }
  }

  /// Closes simplices whose known upper bound does not exceed the goal.
  void TakeKnown(const KnownBounds& known)
  {
    this->Max.Join(known.Max);
    if (known.Upper.empty())
    {
      return;
    }
    const PieceSearch search(this->Source, this->TargetSet, this->Values, this->Goal, this->Max);
    const double goal = search.ClosingBound();
    const auto isClosed = [&](Index simplex) { return known.Upper[simplex] <= goal; };
    for (const Index simplex : this->OpenSimplices)
    {
      this->MaxClosed =
        isClosed(simplex) ? std::max(this->MaxClosed, known.Upper[simplex]) : this->MaxClosed;
    }
    this->OpenSimplices.erase(
      std::remove_if(this->OpenSimplices.begin(), this->OpenSimplices.end(), isClosed),
      this->OpenSimplices.end());
  }

  bool MayCut() const { return !this->OpenSimplices.empty() && this->Cuts < this->Goal.MaxCuts; }

  /// mm, an upper bound of an open simplex before its search in this round.
  double UpperBefore(const PieceSearch& search, std::size_t open) const
  {
    return this->OpenUppers.empty() ? search.UpperWithoutCuts(this->OpenSimplices[open])
                                    : this->OpenUppers[open];
  }

  double UpperBefore(std::size_t first, std::size_t last) const
  {
    const PieceSearch search(this->Source, this->TargetSet, this->Values, this->Goal, this->Max);
    double upper = -Infinity;
    for (std::size_t i = first; i < last; ++i)
    {
      upper = std::max(upper, this->UpperBefore(search, i));
    }
    return upper;
  }

  /// UpperBefore() of each part.
  std::vector<double> UpperOfParts() const
  {
    std::vector<double> uppers(NumberOfChunks(this->OpenSimplices.size()));
    ForEachChunk(this->OpenSimplices.size(), this->Goal.NumberOfThreads, Monitor(),
      [&](std::size_t chunk, std::size_t first, std::size_t last)
      { uppers[chunk] = this->UpperBefore(first, last); });
    return uppers;
  }

  bool Round(std::int64_t maxCuts, const Monitor& monitor, const SearchListener& listener)
  {
    const std::int64_t evenCuts = std::max<std::int64_t>(
      1, (this->Goal.MaxCuts - this->Cuts) / static_cast<std::int64_t>(this->OpenSimplices.size()));
    const std::int64_t cuts = std::min(maxCuts, evenCuts);
    std::vector<Part> parts(NumberOfChunks(this->OpenSimplices.size()));
    const std::vector<double> before = listener ? this->UpperOfParts() : std::vector<double>();
    const Monitor tell = [&](double done)
    {
      if (listener)
      {
        this->Tell(parts, before, listener);
      }
      return monitor(done);
    };
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> isStopped{ false };
    const auto isInterrupted = [&]
    {
      isStopped = isStopped || (std::this_thread::get_id() == caller && !monitor(0.0));
      return isStopped.load();
    };
    const bool shouldContinue =
      ForEachChunk(this->OpenSimplices.size(), this->Goal.NumberOfThreads, tell,
        [&](std::size_t chunk, std::size_t first, std::size_t last)
        { this->SearchPart(first, last, cuts, isInterrupted, parts[chunk]); });
    this->Join(parts);
    return shouldContinue;
  }

  void Tell(const std::vector<Part>& parts, const std::vector<double>& before,
    const SearchListener& listener) const
  {
    double upper = this->MaxClosed;
    MaxExcess max = this->Max;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const bool isDone = parts[i].IsDone.load(std::memory_order_acquire);
      upper = std::max(upper, isDone ? parts[i].Upper() : before[i]);
      if (isDone)
      {
        max.Join(parts[i].Max);
      }
    }
    listener(upper, max);
  }

  /// Takes the parts of a round, of which some are not done after an abort.
  void Join(const std::vector<Part>& parts)
  {
    std::vector<Index> open;
    std::vector<double> uppers;
    this->MaxOpen = -Infinity;
    const std::size_t size = ChunkSize(this->OpenSimplices.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const Part& part = parts[i];
      const double upperOfOpen = part.IsDone
        ? part.MaxOpen
        : this->UpperBefore(i * size, std::min(this->OpenSimplices.size(), (i + 1) * size));
      this->MaxOpen = std::max(this->MaxOpen, upperOfOpen);
      this->Max.Join(part.Max);
      this->MaxClosed = std::max(this->MaxClosed, part.MaxClosed);
      this->Cuts += part.Cuts;
      open.insert(open.end(), part.OpenSimplices.begin(), part.OpenSimplices.end());
      uppers.insert(uppers.end(), part.OpenUppers.begin(), part.OpenUppers.end());
    }
    this->OpenSimplices = std::move(open);
    this->OpenUppers = std::move(uppers);
  }

  void SearchPart(std::size_t first, std::size_t last, std::int64_t cuts,
    const std::function<bool()>& isInterrupted, Part& part) const
  {
    PieceSearch search(this->Source, this->TargetSet, this->Values, this->Goal, this->Max);
    search.SetInterruption(isInterrupted);
    for (std::size_t i = first; i < last; ++i)
    {
      const double left = search.Explore(this->OpenSimplices[i], cuts);
      if (left > -Infinity)
      {
        part.OpenSimplices.push_back(this->OpenSimplices[i]);
        part.OpenUppers.push_back(left);
        part.MaxOpen = std::max(part.MaxOpen, left);
      }
    }
    part.Max = search.Max();
    part.MaxClosed = search.MaxClosedUpper();
    part.Cuts = search.Cuts();
    part.IsDone.store(true, std::memory_order_release);
  }

  DistanceBounds Bounds() const
  {
    DistanceBounds bounds;
    bounds.Upper = std::max(this->MaxClosed, this->MaxOpen);
    bounds.Cuts = this->Cuts;
    if (this->Max.Simplex == None)
    {
      return bounds; // the source is empty
    }
    const MaxExcess& found = this->Max;
    const double value =
      this->TargetSet.ValueFromBelow(found.Position, found.Value + found.Tolerance);
    const bool isDistance = this->Source.PointTolerance.empty() && !this->TargetSet.HasTolerances();
    bounds.Lower =
      std::max(value - found.Tolerance - this->Goal.Slack, isDistance ? 0.0 : -Infinity);
    bounds.Position = found.Position;
    bounds.Triangle = found.Simplex;
    bounds.NearestTriangle = found.Nearest;
    return bounds;
  }

  const Simplices& Source;
  const Target& TargetSet;
  const PointValues& Values;
  const SearchGoal& Goal;
  std::vector<Index> OpenSimplices; // simplices with pieces that are not closed
  std::vector<double> OpenUppers;   // mm, of their open pieces; empty before the first round
  MaxExcess Max;
  double MaxClosed = -Infinity; // mm, the largest upper bound of closed pieces
  double MaxOpen = -Infinity;   // mm, the same of open pieces
  std::int64_t Cuts = 0;
};
}

//------------------------------------------------------------------------------
PointValues FindPointValues(const Simplices& source, const Target& target, bool allPoints,
  double sufficient, int threads, const Monitor& monitor)
{
  PointValues values;
  values.Value.assign(source.Points.size(), std::numeric_limits<double>::quiet_NaN());
  values.Simplex.assign(source.Points.size(), None);
  const auto evaluate = [&](std::size_t point, Index hint)
  {
    const Target::Candidate found = target.FindNear(source.Points[point], hint, sufficient);
    values.Value[point] = found.Value;
    values.Simplex[point] = found.Simplex;
  };
  const std::vector<Index> firstOf = FirstSimplices(source);
  ForEachChunk(source.Size(), threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      // near a corner of the simplex, if one is known from this chunk
      Index hint = None;
      for (std::size_t simplex = first; simplex < last; ++simplex)
      {
        for (const bool isKnown : { true, false })
        {
          for (const Index corner : source.Corners[simplex])
          {
            const Index owner = corner != None ? firstOf[corner] : None;
            const bool isOwn = owner == static_cast<Index>(simplex);
            if (!isKnown && isOwn)
            {
              evaluate(corner, hint);
            }
            const bool isDone = owner >= static_cast<Index>(first) && (!isOwn || !isKnown);
            hint = isDone ? values.Simplex[corner] : hint;
          }
        }
      }
    });
  ForEachId(allPoints ? source.Points.size() : 0, threads,
    [&](std::size_t point)
    {
      if (firstOf[point] == None && IsUsable(source.Points[point]))
      {
        evaluate(point, None);
      }
    });
  return values;
}

//------------------------------------------------------------------------------
DistanceBounds FindMaxExcess(const Simplices& source, const Target& target,
  const PointValues& values, const SearchGoal& goal, const KnownBounds& known,
  const Monitor& monitor, const SearchListener& listener)
{
  return Rounds(source, target, values, goal).Run(known, monitor, listener);
}

//------------------------------------------------------------------------------
DistanceBounds FindBoundsWithoutCuts(
  const Simplices& source, const Target& target, const PointValues& values, const SearchGoal& goal)
{
  return Rounds(source, target, values, goal).RunWithoutCuts();
}
}
