// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DirectedSearch.h"

#include "FirstBounds.h"
#include "Frame.h"
#include "MeanDistance.h"
#include "SideFinder.h"
#include "TriangleBounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bonedecimate::certificate
{
namespace
{
constexpr std::int64_t MinMaxCuts = std::int64_t{ 1 } << 26;
constexpr std::int64_t CutsPerSimplex = 16;
/// The default gap of the search, 1e-9 of the extent, and the least that can be reached, because
/// both bounds are widened by the slack.
constexpr double SlacksOfGap = 2048.0;
constexpr double MinSlacksOfGap = 4.0;
/// A lower bound takes a look at every simplex of the target, so it waits for a distance that is
/// larger by this factor.
constexpr double WorthALowerBound = 1.01;

ProofStatus Evaluate(const DistanceBounds& bounds, double tolerance)
{
  return bounds.Upper <= tolerance ? ProofStatus::Proved
    : bounds.Lower > tolerance     ? ProofStatus::Violated
                                   : ProofStatus::Undecided;
}

/// Combines the bounds of two searches.
void Tighten(DistanceBounds& bounds, const DistanceBounds& other)
{
  const double upper = std::min(bounds.Upper, other.Upper);
  const std::int64_t cuts = bounds.Cuts + other.Cuts;
  if (other.Lower > bounds.Lower)
  {
    bounds = other;
  }
  bounds.Upper = upper;
  bounds.Cuts = cuts;
}

void NameTriangles(DistanceBounds& bounds, const Simplices& source, const Simplices& target)
{
  bounds.Triangle = source.TriangleId(bounds.Triangle);
  bounds.NearestTriangle = target.TriangleId(bounds.NearestTriangle);
}
}

//------------------------------------------------------------------------------
DirectedSearch::DirectedSearch(const Simplices& source, const Simplices& target,
  const PairTask& task, double triangleGap, std::function<void()> tell)
  : Source(source)
  , TargetSet(target)
  , Task(task)
  , TriangleGap(task.AreSurfaces ? triangleGap : 0.0)
  , Goal(this->FirstGoal(source.Size()))
  , TellOuter(std::move(tell))
{
  if (this->TellOuter)
  {
    this->Known = FindFirstBounds(source, target, task.Slack);
  }
}

//------------------------------------------------------------------------------
SearchGoal DirectedSearch::FirstGoal(std::size_t simplices) const
{
  const CertificateOptions& options = this->Task.Options;
  SearchGoal goal;
  goal.MaxCuts = options.MaxCuts > 0
    ? options.MaxCuts
    : MinMaxCuts + CutsPerSimplex * static_cast<std::int64_t>(simplices);
  goal.RelativeGap = options.RelativeGap;
  goal.Slack = this->Task.Slack;
  goal.MinGap = std::max(SlacksOfGap * this->Task.Slack, options.MinGap);
  goal.NumberOfThreads = options.NumberOfThreads;
  const bool stopAtTolerance = options.Tolerance && !options.TightBounds;
  goal.CloseBelow = stopAtTolerance ? *options.Tolerance : -Infinity;
  return goal;
}

//------------------------------------------------------------------------------
/// Takes an upper bound, and a lower bound from the position that was found.
void DirectedSearch::Narrow(double upper, const MaxExcess& max)
{
  this->Known.Upper = std::min(this->Known.Upper, upper);
  if (max.Simplex != None && max.Value > WorthALowerBound * this->LargestFound)
  {
    this->LargestFound = max.Value;
    const double lower = this->To->ValueFromBelow(max.Position, max.Value) - this->Goal.Slack;
    if (lower > this->Known.Lower)
    {
      this->Known.Lower = lower;
      this->Known.Position = max.Position;
      this->Known.Triangle = max.Simplex;
      this->Known.NearestTriangle = max.Nearest;
    }
  }
}

//------------------------------------------------------------------------------
void DirectedSearch::Tell()
{
  if (this->TellOuter)
  {
    this->TellOuter();
  }
}

//------------------------------------------------------------------------------
SearchListener DirectedSearch::Listener()
{
  if (!this->TellOuter)
  {
    return {};
  }
  return [this](double upper, const MaxExcess& max)
  {
    this->Narrow(upper, max);
    this->Tell();
  };
}

//------------------------------------------------------------------------------
/// After an abort: narrows the bounds by all that was computed.
void DirectedSearch::Conclude()
{
  Tighten(this->Known, FindFirstBounds(this->Source, this->TargetSet, this->Task.Slack));
  if (this->To)
  {
    this->Narrow(this->UpperOfParts(), {});
  }
  if (this->HasValues)
  {
    Tighten(this->Known,
      FindBoundsWithoutCuts(this->Source, *this->To, this->PointDistances, this->Goal));
  }
}

//------------------------------------------------------------------------------
void DirectedSearch::BuildTarget(const std::function<void()>& afterStep)
{
  this->To.emplace(this->TargetSet, this->Goal.NumberOfThreads, afterStep);
}

//------------------------------------------------------------------------------
void DirectedSearch::TakeParts()
{
  if (this->TellOuter)
  {
    this->Narrow(this->UpperOfParts(), {});
    this->Tell();
  }
}

//------------------------------------------------------------------------------
double DirectedSearch::UpperOfParts() const
{
  return FindUpperOfParts(this->Source, *this->To, this->Task.Slack, this->Goal.NumberOfThreads);
}

//------------------------------------------------------------------------------
void DirectedSearch::FindValues(Stages& progress, double weight)
{
  this->PointDistances = this->Values(progress, weight, this->SufficientValue());
  this->HasValues = progress.ShouldContinue();
  if (this->HasValues && this->TellOuter)
  {
    Tighten(this->Known,
      FindBoundsWithoutCuts(this->Source, *this->To, this->PointDistances, this->Goal));
    this->Tell();
  }
}

//------------------------------------------------------------------------------
/// @param sufficient mm; values up to this need not be the least if there are larger ones.
PointValues DirectedSearch::Values(Stages& progress, double weight, double sufficient) const
{
  const bool allPoints = this->Task.AreSurfaces && this->Task.Options.WithPointDistances;
  PointValues values = FindPointValues(this->Source, *this->To, allPoints, sufficient,
    this->Goal.NumberOfThreads, progress.Next(weight));
  const bool hasMore = std::any_of(values.Value.begin(), values.Value.end(),
    [sufficient](double value) { return value > sufficient; });
  return sufficient < 0.0 || hasMore || !progress.ShouldContinue()
    ? values
    : this->Values(progress, 0.0, -1.0);
}

//------------------------------------------------------------------------------
/// mm, for Values: well below what the largest distance probably is. Negative if all values have
/// to be exact.
double DirectedSearch::SufficientValue() const
{
  const CertificateOptions& options = this->Task.Options;
  const bool needsAll = !this->Task.AreSurfaces || this->TriangleGap > 0.0 || options.WithMeans ||
    options.WithPointDistances;
  return needsAll ? -1.0 : 0.5 * options.Tolerance.value_or(-1.0);
}

//------------------------------------------------------------------------------
DistanceBounds DirectedSearch::Find(const KnownBounds& known, const Monitor& monitor)
{
  return FindMaxExcess(
    this->Source, *this->To, this->PointDistances, this->Goal, known, monitor, this->Listener());
}

//------------------------------------------------------------------------------
void DirectedSearch::FindDistance(Stages& progress, double weight)
{
  KnownBounds known;
  if (this->TriangleGap > 0.0)
  {
    known = this->BoundTriangles(progress.Next(0.4 * weight));
    weight *= 0.6;
  }
  if (!progress.ShouldContinue())
  {
    return;
  }
  DistanceBounds& found = this->Output.Distance;
  found = this->Find(known, progress.Next(weight));
  const std::optional<double>& tolerance = this->Task.Options.Tolerance;
  if (tolerance && progress.ShouldContinue())
  {
    this->Decide(*tolerance, progress);
  }
  Tighten(this->Known, found);
  this->Tell();
  for (double& upper : known.Upper)
  {
    upper = std::min(upper, found.Upper);
  }
  this->Output.TriangleUpper = std::move(known.Upper);
}

//------------------------------------------------------------------------------
/// Repeats the search with a smaller gap if the tolerance lies between the bounds.
void DirectedSearch::Decide(double tolerance, Stages& progress)
{
  this->Output.Proof = Evaluate(this->Output.Distance, tolerance);
  if (this->Output.Proof == ProofStatus::Undecided)
  {
    this->Goal.CloseBelow = tolerance;
    this->Goal.RelativeGap = 0.0;
    this->Goal.MinGap = MinSlacksOfGap * this->Goal.Slack;
    Tighten(this->Output.Distance, this->Find({}, progress.Next(0.0)));
    this->Output.Proof = Evaluate(this->Output.Distance, tolerance);
  }
}

//------------------------------------------------------------------------------
KnownBounds DirectedSearch::BoundTriangles(const Monitor& monitor) const
{
  SearchGoal goal = this->Goal;
  goal.CloseBelow = -Infinity;
  goal.RelativeGap = 0.0;
  goal.MinGap = std::max(this->TriangleGap, MinSlacksOfGap * goal.Slack);
  KnownBounds known;
  known.Upper =
    FindTriangleBounds(this->Source, *this->To, this->PointDistances, goal, known.Max, monitor);
  return known;
}

//------------------------------------------------------------------------------
void DirectedSearch::FindExcessOverPoints(
  const std::vector<double>& limit, Stages& progress, double weight)
{
  const Simplices limited = LimitedPart(this->Source, limit);
  this->FindExcess(limited, MaxFinite(limit), progress, weight);
  NameTriangles(this->Output.Excess, limited, this->TargetSet);
}

//------------------------------------------------------------------------------
void DirectedSearch::FindExcessOverSimplices(
  std::vector<double> limits, Stages& progress, double weight)
{
  const double largest = *std::max_element(limits.begin(), limits.end());
  this->To->SetTolerances(std::move(limits));
  this->FindExcess(this->Source, largest, progress, weight);
  NameTriangles(this->Output.Excess, this->Source, this->TargetSet);
  this->To->SetTolerances({});
}

//------------------------------------------------------------------------------
void DirectedSearch::FindExcess(
  const Simplices& source, double largest, Stages& progress, double weight)
{
  SearchGoal goal = this->FirstGoal(source.Size());
  goal.CloseBelow = 0.0;
  goal.Scale = largest;
  const bool allPoints = this->Task.AreSurfaces && this->Task.Options.WithPointDistances;
  const PointValues values = FindPointValues(
    source, *this->To, allPoints, -1.0, goal.NumberOfThreads, progress.Next(0.5 * weight));
  const auto find = [&](double part)
  { return FindMaxExcess(source, *this->To, values, goal, {}, progress.Next(part)); };
  if (!progress.ShouldContinue())
  {
    return;
  }
  this->Output.Excess = find(0.5 * weight);
  this->Output.Proof = Evaluate(this->Output.Excess, 0.0);
  this->HasExcess = true;
  if (this->Output.Proof == ProofStatus::Undecided && progress.ShouldContinue())
  {
    // Unmoved parts with a tolerance of 0 have an excess of exactly 0: no gap is allowed above it.
    goal.Decides = true;
    Tighten(this->Output.Excess, find(0.0));
    this->Output.Proof = Evaluate(this->Output.Excess, 0.0);
  }
}

//------------------------------------------------------------------------------
void DirectedSearch::MarkUnlimited()
{
  this->Output.Excess.Upper = -Infinity;
  this->Output.Proof = ProofStatus::Proved;
  this->HasExcess = true;
}

//------------------------------------------------------------------------------
void DirectedSearch::AddStatistics(Stages& progress, double weight)
{
  const CertificateOptions& options = this->Task.Options;
  const Monitor monitor = progress.Next(weight);
  if (options.WithMeans)
  {
    this->Output.Mean = FindMeanDistance(this->Source, *this->To, this->PointDistances,
      options.MeanPrecision, this->Task.Slack, this->Goal.NumberOfThreads, monitor);
  }
  if (options.WithPointDistances && progress.ShouldContinue())
  {
    this->Output.Points.Distance = this->PointDistances.Value;
    this->Output.Points.Side = FindSides(this->Source.Points, this->PointDistances.Simplex,
      this->TargetSet, this->Goal.NumberOfThreads);
  }
}

//------------------------------------------------------------------------------
/// After an abort. What exceeds the largest tolerance violates the map, too.
ProofStatus DirectedSearch::ProofSoFar(ProofStatus found) const
{
  const CertificateOptions& options = this->Task.Options;
  const bool hasMap = !options.ToleranceMap.empty();
  if (!options.Tolerance && !hasMap)
  {
    return ProofStatus::NotRequested;
  }
  if (hasMap && this->HasExcess)
  {
    return found;
  }
  const ProofStatus ofAll =
    options.Tolerance ? Evaluate(this->Known, *options.Tolerance) : ProofStatus::Undecided;
  return hasMap && ofAll == ProofStatus::Proved ? ProofStatus::Undecided : ofAll;
}

//------------------------------------------------------------------------------
DirectedCertificate DirectedSearch::Found(bool wasStopped)
{
  DirectedCertificate found = std::move(this->Output);
  if (wasStopped)
  {
    this->Conclude();
    found.Distance = this->Known;
    found.Proof = this->ProofSoFar(found.Proof);
  }
  NameTriangles(found.Distance, this->Source, this->TargetSet);
  return found;
}
}
