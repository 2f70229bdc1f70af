// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PairCertificate.h"

#include "MeanDistance.h"
#include "Search.h"
#include "SideFinder.h"
#include "Target.h"
#include "TriangleBounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bonedecimate::certificate
{
namespace
{
constexpr std::int64_t MinMostCuts = std::int64_t{ 1 } << 26;
constexpr std::int64_t CutsASimplex = 16;
/// The least gap of the search, 1e-9 of the extent, and the least that can be reached: both bounds are widened by the slack.
constexpr double SlacksOfGap = 2048.0;
constexpr double FewestSlacks = 4.0;

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

/// Certifies one direction. The excess is taken over the tolerances of the target.
class Direction
{
public:
  /// @param triangleGap mm, of the bounds of single triangles; 0: they are not computed.
  Direction(const Simplices& source, const Target& target, const PairTask& task, double triangleGap)
    : Source(source)
    , To(target)
    , Task(task)
    , TriangleGap(task.OfSurfaces ? triangleGap : 0.0)
  {
    const std::int64_t requested = task.Options.MaxCuts;
    this->Goal.MaxCuts = requested > 0
      ? requested
      : MinMostCuts + CutsASimplex * static_cast<std::int64_t>(source.Size());
    this->Goal.RelativeGap = task.Options.RelativeGap;
    this->Goal.Slack = task.Slack;
    this->Goal.MinGap = std::max(SlacksOfGap * task.Slack, task.Options.MinGap);
    this->Goal.NumberOfThreads = task.Options.NumberOfThreads;
  }

  void FindDistance(DirectedCertificate& bounds, Stages& progress, double weight)
  {
    const std::optional<double>& tolerance = this->Task.Options.Tolerance;
    const bool stopAtTolerance = tolerance && !this->Task.Options.TightBounds;
    this->Goal.CloseBelow = stopAtTolerance ? *tolerance : -Infinity;
    const PointValues values = this->Values(progress, 0.4 * weight, this->Enough());
    KnownBounds known;
    if (this->TriangleGap > 0.0 && progress.GoesOn())
    {
      known = this->BoundTriangles(values, progress.Next(0.2 * weight));
    }
    if (progress.GoesOn())
    {
      bounds.Distance = this->Find(values, known, progress.Next(0.3 * weight));
    }
    if (tolerance && progress.GoesOn())
    {
      this->Decide(*tolerance, values, bounds, progress);
    }
    for (double& upper : known.Upper)
    {
      upper = std::min(upper, bounds.Distance.Upper);
    }
    bounds.TriangleUpper = std::move(known.Upper);
    if (this->Task.OfSurfaces && progress.GoesOn())
    {
      this->Describe(values, bounds, progress.Next(0.1 * weight));
    }
  }

  void FindExcess(
    DirectedCertificate& bounds, double largestTolerance, Stages& progress, double weight)
  {
    this->Goal.CloseBelow = 0.0;
    this->Goal.Scale = largestTolerance;
    const PointValues values = this->Values(progress, 0.5 * weight);
    if (progress.GoesOn())
    {
      bounds.Excess = this->Find(values, {}, progress.Next(0.5 * weight));
      bounds.Proof = Evaluate(bounds.Excess, 0.0);
    }
    if (bounds.Proof == ProofStatus::Undecided && progress.GoesOn())
    {
      // Unmoved parts with a tolerance of 0 have an excess of exactly 0: no gap is allowed above it.
      this->Goal.Decides = true;
      Tighten(bounds.Excess, this->Find(values, {}, progress.Next(0.0)));
      bounds.Proof = Evaluate(bounds.Excess, 0.0);
    }
  }

private:
  /// @param enough mm; values up to this need not be the least, unless all are.
  PointValues Values(Stages& progress, double weight, double enough = -1.0) const
  {
    const bool ofAll = this->Task.OfSurfaces && this->Task.Options.WithPointDistances;
    PointValues values = FindPointValues(
      this->Source, this->To, ofAll, enough, this->Goal.NumberOfThreads, progress.Next(weight));
    const bool hasMore = std::any_of(
      values.Value.begin(), values.Value.end(), [enough](double value) { return value > enough; });
    return enough < 0.0 || hasMore || !progress.GoesOn() ? values : this->Values(progress, 0.0);
  }

  /// mm, for Values: well below what the largest distance is likely to be. Negative if more than that is needed of the values.
  double Enough() const
  {
    const CertificateOptions& options = this->Task.Options;
    const bool needsAll = !this->Task.OfSurfaces || this->TriangleGap > 0.0 || options.WithMeans ||
      options.WithPointDistances;
    return needsAll ? -1.0 : 0.5 * options.Tolerance.value_or(-1.0);
  }

  /// Repeats the search with a smaller gap if the tolerance lies between the bounds.
  void Decide(
    double tolerance, const PointValues& values, DirectedCertificate& bounds, Stages& progress)
  {
    bounds.Proof = Evaluate(bounds.Distance, tolerance);
    if (bounds.Proof == ProofStatus::Undecided)
    {
      this->Goal.CloseBelow = tolerance;
      this->Goal.RelativeGap = 0.0;
      this->Goal.MinGap = FewestSlacks * this->Goal.Slack;
      Tighten(bounds.Distance, this->Find(values, {}, progress.Next(0.0)));
      bounds.Proof = Evaluate(bounds.Distance, tolerance);
    }
  }

  KnownBounds BoundTriangles(const PointValues& values, const Monitor& monitor) const
  {
    SearchGoal goal = this->Goal;
    goal.CloseBelow = -Infinity;
    goal.RelativeGap = 0.0;
    goal.MinGap = std::max(this->TriangleGap, FewestSlacks * goal.Slack);
    KnownBounds known;
    known.Upper = FindTriangleBounds(this->Source, this->To, values, goal, known.Largest, monitor);
    return known;
  }

  void Describe(const PointValues& values, DirectedCertificate& bounds, const Monitor& monitor)
  {
    const CertificateOptions& options = this->Task.Options;
    if (options.WithMeans)
    {
      bounds.Mean = FindMeanDistance(
        this->Source, this->To, values, options.MeanPrecision, this->Goal.NumberOfThreads, monitor);
    }
    if (options.WithPointDistances)
    {
      bounds.Points.Distance = values.Value;
      bounds.Points.Side =
        FindSides(this->Source.Points, values.Simplex, this->To.All(), this->Goal.NumberOfThreads);
    }
  }

  DistanceBounds Find(
    const PointValues& values, const KnownBounds& known, const Monitor& monitor) const
  {
    return FindLargestExcess(this->Source, this->To, values, this->Goal, known, monitor);
  }

  const Simplices& Source;
  const Target& To;
  const PairTask& Task;
  double TriangleGap; // mm
  SearchGoal Goal;
};

/// mm, the least limit of the corners of each simplex.
std::vector<double> MinLimits(const Simplices& simplices, const std::vector<double>& limit)
{
  std::vector<double> least;
  least.reserve(simplices.Size());
  for (const Triangle& corners : simplices.Corners)
  {
    double most = Infinity;
    for (const Index corner : corners)
    {
      most = corner == None ? most : std::min(most, limit[corner]);
    }
    least.push_back(most);
  }
  return least;
}

double MaxFinite(const std::vector<double>& limits)
{
  double largest = 0.0;
  for (const double limit : limits)
  {
    largest = std::isfinite(limit) ? std::max(largest, limit) : largest;
  }
  return largest;
}

void NameTriangles(DistanceBounds& bounds, const Simplices& source, const Simplices& target)
{
  bounds.Triangle = source.TriangleId(bounds.Triangle);
  bounds.NearestTriangle = target.TriangleId(bounds.NearestTriangle);
}

/// The bounds if there is no finite limit.
void Allow(DirectedCertificate& bounds)
{
  bounds.Excess.Upper = -Infinity;
  bounds.Proof = ProofStatus::Proved;
}

/// The surfaces, the limits and the progress of one comparison.
struct Comparison
{
  const Simplices& Reference;
  const Simplices& Result;
  const std::vector<double>& Limit;
  const PairTask& Task;
  Stages& Progress;
  double Weight; // of one search in the progress

  Target TargetOf(const Simplices& simplices) const
  {
    const Monitor tell = this->Progress.Next(0.0);
    return Target(simplices, this->Task.Options.NumberOfThreads, [&] { tell(1.0); });
  }
};

DirectedCertificate Forward(const Comparison& both)
{
  DirectedCertificate bounds;
  const Target target = both.TargetOf(both.Result);
  Direction(both.Reference, target, both.Task, both.Task.Options.ReferenceTriangleGap)
    .FindDistance(bounds, both.Progress, both.Weight);
  NameTriangles(bounds.Distance, both.Reference, both.Result);
  if (both.Limit.empty() || !both.Progress.GoesOn())
  {
    return bounds;
  }
  const Simplices limited = LimitedPart(both.Reference, both.Limit);
  if (limited.Size() == 0)
  {
    Allow(bounds);
    return bounds;
  }
  Direction(limited, target, both.Task, 0.0)
    .FindExcess(bounds, MaxFinite(both.Limit), both.Progress, both.Weight);
  NameTriangles(bounds.Excess, limited, both.Result);
  return bounds;
}

DirectedCertificate Backward(const Comparison& both)
{
  DirectedCertificate bounds;
  Target target = both.TargetOf(both.Reference);
  Direction(both.Result, target, both.Task, both.Task.Options.ResultTriangleGap)
    .FindDistance(bounds, both.Progress, both.Weight);
  NameTriangles(bounds.Distance, both.Result, both.Reference);
  if (both.Limit.empty() || !both.Progress.GoesOn())
  {
    return bounds;
  }
  std::vector<double> least = MinLimits(both.Reference, both.Limit);
  const double largest = *std::max_element(least.begin(), least.end());
  if (!std::isfinite(largest))
  {
    Allow(bounds);
    return bounds;
  }
  target.SetTolerances(std::move(least));
  Direction(both.Result, target, both.Task, 0.0)
    .FindExcess(bounds, largest, both.Progress, both.Weight);
  NameTriangles(bounds.Excess, both.Result, both.Reference);
  return bounds;
}

DirectedCertificate Alone(const BoundarySet& source, const PairTask& task)
{
  DirectedCertificate bounds;
  const bool isEmpty = source.Segments.Size() == 0;
  bounds.Distance.Lower = bounds.Distance.Upper = isEmpty ? 0.0 : Infinity;
  bounds.Distance.Triangle = isEmpty ? None : source.Segments.TriangleId(0);
  bounds.Distance.Position = isEmpty ? Vector3::Zero() : source.Segments.Points[0];
  if (!task.Options.ToleranceMap.empty() || task.Options.Tolerance)
  {
    const bool isFree = isEmpty ||
      (!source.Limit.empty() &&
        std::none_of(source.Limit.begin(), source.Limit.end(),
          [](double limit) { return std::isfinite(limit); }));
    bounds.Excess = bounds.Distance;
    bounds.Excess.Upper = bounds.Excess.Lower = isFree ? -Infinity : Infinity;
    bounds.Proof = isFree ? ProofStatus::Proved : ProofStatus::Violated;
  }
  return bounds;
}
}

//------------------------------------------------------------------------------
PairCertificate CertifyPair(const Simplices& reference, const Simplices& result,
  const std::vector<double>& limit, const PairTask& task, Stages& progress, double weight)
{
  const double part = limit.empty() ? 0.5 * weight : 0.25 * weight;
  const Comparison both = { reference, result, limit, task, progress, part };
  PairCertificate pair;
  pair.ReferenceToResult = Forward(both);
  if (progress.GoesOn() && !task.Options.OneSided)
  {
    pair.ResultToReference = Backward(both);
  }
  return pair;
}

//------------------------------------------------------------------------------
PairCertificate WithoutPartner(
  const BoundarySet& reference, const BoundarySet& result, const PairTask& task)
{
  return { Alone(reference, task), Alone(result, task) };
}
}
