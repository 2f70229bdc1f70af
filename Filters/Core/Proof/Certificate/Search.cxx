// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search.h"

#include "Base/Parallel.h"
#include "Frame.h"
#include "PieceSearch.h"

#include <algorithm>
#include <numeric>

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
    , To(target)
    , Values(values)
    , Goal(goal)
    , Open(source.Size())
  {
    std::iota(this->Open.begin(), this->Open.end(), 0);
  }

  DistanceBounds Run(const KnownBounds& known, const Monitor& monitor)
  {
    this->TakeCorners();
    this->TakeKnown(known);
    bool goesOn = true;
    double from = 0.0;
    double to = ProgressOfFirstRound;
    for (std::int64_t cuts = FirstCuts; goesOn && this->MayCut(); cuts *= MoreCuts)
    {
      goesOn = this->Round(cuts, PartOf(monitor, from, to));
      from = to;
      to += 0.5 * (1.0 - to);
    }
    return goesOn ? this->Bounds() : DistanceBounds();
  }

private:
  struct Part
  {
    MaxExcess Largest;
    double Closed = -Infinity;
    double Left = -Infinity;
    std::int64_t Cuts = 0;
    std::vector<Index> Open;
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
        this->Largest.Join({ this->Values.Value[point] - tolerance, tolerance,
          this->Source.Points[point], static_cast<Index>(simplex), this->Values.Simplex[point] });
      }
    }
  }

  /// Closes simplices that are known to lie below what is known to be reached.
  void TakeKnown(const KnownBounds& known)
  {
    this->Largest.Join(known.Largest);
    if (known.Upper.empty())
    {
      return;
    }
    const PieceSearch search(this->Source, this->To, this->Values, this->Goal, this->Largest);
    const double goal = search.ClosingBound();
    const auto isClosed = [&](Index simplex) { return known.Upper[simplex] <= goal; };
    for (const Index simplex : this->Open)
    {
      this->Closed =
        isClosed(simplex) ? std::max(this->Closed, known.Upper[simplex]) : this->Closed;
    }
    this->Open.erase(
      std::remove_if(this->Open.begin(), this->Open.end(), isClosed), this->Open.end());
  }

  bool MayCut() const { return !this->Open.empty() && this->Cuts < this->Goal.MaxCuts; }

  bool Round(std::int64_t mostCuts, const Monitor& monitor)
  {
    const std::int64_t evenCuts = std::max<std::int64_t>(
      1, (this->Goal.MaxCuts - this->Cuts) / static_cast<std::int64_t>(this->Open.size()));
    const std::int64_t cuts = std::min(mostCuts, evenCuts);
    std::vector<Part> parts(NumberOfChunks(this->Open.size()));
    const bool goesOn = ForEachChunk(this->Open.size(), this->Goal.NumberOfThreads, monitor,
      [&](std::size_t chunk, std::size_t first, std::size_t last)
      { this->SearchPart(first, last, cuts, parts[chunk]); });
    this->Open.clear();
    this->Left = -Infinity;
    for (const Part& part : parts)
    {
      this->Largest.Join(part.Largest);
      this->Closed = std::max(this->Closed, part.Closed);
      this->Left = std::max(this->Left, part.Left);
      this->Cuts += part.Cuts;
      this->Open.insert(this->Open.end(), part.Open.begin(), part.Open.end());
    }
    return goesOn;
  }

  void SearchPart(std::size_t first, std::size_t last, std::int64_t cuts, Part& part) const
  {
    PieceSearch search(this->Source, this->To, this->Values, this->Goal, this->Largest);
    for (std::size_t i = first; i < last; ++i)
    {
      const double left = search.Explore(this->Open[i], cuts);
      if (left > -Infinity)
      {
        part.Open.push_back(this->Open[i]);
        part.Left = std::max(part.Left, left);
      }
    }
    part.Largest = search.Largest();
    part.Closed = search.Closed();
    part.Cuts = search.Cuts();
  }

  DistanceBounds Bounds() const
  {
    DistanceBounds bounds;
    bounds.Upper = std::max(this->Closed, this->Left);
    bounds.Cuts = this->Cuts;
    if (this->Largest.Simplex == None)
    {
      return bounds; // the source is empty
    }
    const MaxExcess& found = this->Largest;
    const double value = this->To.ValueFromBelow(found.Position, found.Value + found.Tolerance);
    const bool isDistance = this->Source.PointTolerance.empty() && !this->To.HasTolerances();
    bounds.Lower =
      std::max(value - found.Tolerance - this->Goal.Slack, isDistance ? 0.0 : -Infinity);
    bounds.Position = found.Position;
    bounds.Triangle = found.Simplex;
    bounds.NearestTriangle = found.Nearest;
    return bounds;
  }

  const Simplices& Source;
  const Target& To;
  const PointValues& Values;
  const SearchGoal& Goal;
  std::vector<Index> Open; // simplices with pieces that are not closed
  MaxExcess Largest;
  double Closed = -Infinity; // mm, the largest upper bound of closed pieces
  double Left = -Infinity;   // mm, the same of open pieces
  std::int64_t Cuts = 0;
};
}

//------------------------------------------------------------------------------
PointValues FindPointValues(const Simplices& source, const Target& target, bool ofAll,
  double enough, int threads, const Monitor& monitor)
{
  PointValues values;
  values.Value.assign(source.Points.size(), std::numeric_limits<double>::quiet_NaN());
  values.Simplex.assign(source.Points.size(), None);
  const auto evaluate = [&](std::size_t point, Index hint)
  {
    const Target::Candidate found = target.FindNear(source.Points[point], hint, enough);
    values.Value[point] = found.Value;
    values.Simplex[point] = found.Simplex;
  };
  const std::vector<Index> firstOf = FirstSimplices(source);
  ForEachChunk(source.Size(), threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Index hint =
        None; // what is near to a corner of the simplex, if that is known from this chunk
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
  ForEachId(ofAll ? source.Points.size() : 0, threads,
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
DistanceBounds FindLargestExcess(const Simplices& source, const Target& target,
  const PointValues& values, const SearchGoal& goal, const KnownBounds& known,
  const Monitor& monitor)
{
  return Rounds(source, target, values, goal).Run(known, monitor);
}
}
