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
constexpr std::int64_t MinMaxCuts = std::int64_t{ 1 } << 26;
constexpr std::int64_t CutsPerSimplex = 16;
/// The default gap of the search, 1e-9 of the extent, and the least that can be reached, because
/// both bounds are widened by the slack.
constexpr double SlacksOfGap = 2048.0;
constexpr double MinSlacksOfGap = 4.0;

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
class DirectedSearch
{
public:
  /// @param triangleGap mm, of the bounds of single triangles; 0: they are not computed.
  DirectedSearch(
    const Simplices& source, const Target& target, const PairTask& task, double triangleGap)
    : Source(source)
    , TargetSet(target)
    , Task(task)
    , TriangleGap(task.AreSurfaces ? triangleGap : 0.0)
  {
    const std::int64_t requested = task.Options.MaxCuts;
    this->Goal.MaxCuts = requested > 0
      ? requested
      : MinMaxCuts + CutsPerSimplex * static_cast<std::int64_t>(source.Size());
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
    const PointValues values = this->Values(progress, 0.4 * weight, this->SufficientValue());
    KnownBounds known;
    if (this->TriangleGap > 0.0 && progress.ShouldContinue())
    {
      known = this->BoundTriangles(values, progress.Next(0.2 * weight));
    }
    if (progress.ShouldContinue())
    {
      bounds.Distance = this->Find(values, known, progress.Next(0.3 * weight));
    }
    if (tolerance && progress.ShouldContinue())
    {
      this->Decide(*tolerance, values, bounds, progress);
    }
    for (double& upper : known.Upper)
    {
      upper = std::min(upper, bounds.Distance.Upper);
    }
    bounds.TriangleUpper = std::move(known.Upper);
    if (this->Task.AreSurfaces && progress.ShouldContinue())
    {
      this->AddStatistics(values, bounds, progress.Next(0.1 * weight));
    }
  }

  void FindExcess(
    DirectedCertificate& bounds, double largestTolerance, Stages& progress, double weight)
  {
    this->Goal.CloseBelow = 0.0;
    this->Goal.Scale = largestTolerance;
    const PointValues values = this->Values(progress, 0.5 * weight);
    if (progress.ShouldContinue())
    {
      bounds.Excess = this->Find(values, {}, progress.Next(0.5 * weight));
      bounds.Proof = Evaluate(bounds.Excess, 0.0);
    }
    if (bounds.Proof == ProofStatus::Undecided && progress.ShouldContinue())
    {
      // Unmoved parts with a tolerance of 0 have an excess of exactly 0: no gap is allowed above
      // it.
      this->Goal.Decides = true;
      Tighten(bounds.Excess, this->Find(values, {}, progress.Next(0.0)));
      bounds.Proof = Evaluate(bounds.Excess, 0.0);
    }
  }

private:
  /// @param sufficient mm; values up to this need not be the least if there are larger ones.
  PointValues Values(Stages& progress, double weight, double sufficient = -1.0) const
  {
    const bool allPoints = this->Task.AreSurfaces && this->Task.Options.WithPointDistances;
    PointValues values = FindPointValues(this->Source, this->TargetSet, allPoints, sufficient,
      this->Goal.NumberOfThreads, progress.Next(weight));
    const bool hasMore = std::any_of(values.Value.begin(), values.Value.end(),
      [sufficient](double value) { return value > sufficient; });
    return sufficient < 0.0 || hasMore || !progress.ShouldContinue() ? values
                                                                     : this->Values(progress, 0.0);
  }

  /// mm, for Values: well below what the largest distance probably is. Negative if all values have
  /// to be exact.
  double SufficientValue() const
  {
    const CertificateOptions& options = this->Task.Options;
    const bool needsAll = !this->Task.AreSurfaces || this->TriangleGap > 0.0 || options.WithMeans ||
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
      this->Goal.MinGap = MinSlacksOfGap * this->Goal.Slack;
      Tighten(bounds.Distance, this->Find(values, {}, progress.Next(0.0)));
      bounds.Proof = Evaluate(bounds.Distance, tolerance);
    }
  }

  KnownBounds BoundTriangles(const PointValues& values, const Monitor& monitor) const
  {
    SearchGoal goal = this->Goal;
    goal.CloseBelow = -Infinity;
    goal.RelativeGap = 0.0;
    goal.MinGap = std::max(this->TriangleGap, MinSlacksOfGap * goal.Slack);
    KnownBounds known;
    known.Upper =
      FindTriangleBounds(this->Source, this->TargetSet, values, goal, known.Max, monitor);
    return known;
  }

  void AddStatistics(const PointValues& values, DirectedCertificate& bounds, const Monitor& monitor)
  {
    const CertificateOptions& options = this->Task.Options;
    if (options.WithMeans)
    {
      bounds.Mean = FindMeanDistance(this->Source, this->TargetSet, values, options.MeanPrecision,
        this->Goal.NumberOfThreads, monitor);
    }
    if (options.WithPointDistances)
    {
      bounds.Points.Distance = values.Value;
      bounds.Points.Side = FindSides(
        this->Source.Points, values.Simplex, this->TargetSet.All(), this->Goal.NumberOfThreads);
    }
  }

  DistanceBounds Find(
    const PointValues& values, const KnownBounds& known, const Monitor& monitor) const
  {
    return FindMaxExcess(this->Source, this->TargetSet, values, this->Goal, known, monitor);
  }

  const Simplices& Source;
  const Target& TargetSet;
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

void NameTriangles(DistanceBounds& bounds, const Simplices& source, const Simplices& target)
{
  bounds.Triangle = source.TriangleId(bounds.Triangle);
  bounds.NearestTriangle = target.TriangleId(bounds.NearestTriangle);
}

/// Marks the bounds as proved: there is no limit to check.
void MarkUnlimited(DirectedCertificate& bounds)
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

DirectedCertificate CertifyForward(const Comparison& both)
{
  DirectedCertificate bounds;
  const Target target = both.TargetOf(both.Result);
  DirectedSearch(both.Reference, target, both.Task, both.Task.Options.ReferenceTriangleGap)
    .FindDistance(bounds, both.Progress, both.Weight);
  NameTriangles(bounds.Distance, both.Reference, both.Result);
  if (both.Limit.empty() || !both.Progress.ShouldContinue())
  {
    return bounds;
  }
  const Simplices limited = LimitedPart(both.Reference, both.Limit);
  if (limited.Size() == 0)
  {
    MarkUnlimited(bounds);
    return bounds;
  }
  DirectedSearch(limited, target, both.Task, 0.0)
    .FindExcess(bounds, MaxFinite(both.Limit), both.Progress, both.Weight);
  NameTriangles(bounds.Excess, limited, both.Result);
  return bounds;
}

DirectedCertificate CertifyBackward(const Comparison& both)
{
  DirectedCertificate bounds;
  Target target = both.TargetOf(both.Reference);
  DirectedSearch(both.Result, target, both.Task, both.Task.Options.ResultTriangleGap)
    .FindDistance(bounds, both.Progress, both.Weight);
  NameTriangles(bounds.Distance, both.Result, both.Reference);
  if (both.Limit.empty() || !both.Progress.ShouldContinue())
  {
    return bounds;
  }
  std::vector<double> least = MinLimits(both.Reference, both.Limit);
  const double max = *std::max_element(least.begin(), least.end());
  if (!std::isfinite(max))
  {
    MarkUnlimited(bounds);
    return bounds;
  }
  target.SetTolerances(std::move(least));
  DirectedSearch(both.Result, target, both.Task, 0.0)
    .FindExcess(bounds, max, both.Progress, both.Weight);
  NameTriangles(bounds.Excess, both.Result, both.Reference);
  return bounds;
}

DirectedCertificate CertifyAlone(const BoundarySet& source, const PairTask& task)
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
double MaxFinite(const std::vector<double>& limits)
{
  double max = 0.0;
  for (const double limit : limits)
  {
    max = std::isfinite(limit) ? std::max(max, limit) : max;
  }
  return max;
}
//------------------------------------------------------------------------------
PairCertificate CertifyPair(const Simplices& reference, const Simplices& result,
  const std::vector<double>& limit, const PairTask& task, Stages& progress, double weight)
{
  const double part = limit.empty() ? 0.5 * weight : 0.25 * weight;
  const Comparison both = { reference, result, limit, task, progress, part };
  PairCertificate pair;
  pair.ReferenceToResult = CertifyForward(both);
  if (progress.ShouldContinue() && !task.Options.OneSided)
  {
    pair.ResultToReference = CertifyBackward(both);
  }
  return pair;
}

//------------------------------------------------------------------------------
PairCertificate WithoutPartner(
  const BoundarySet& reference, const BoundarySet& result, const PairTask& task)
{
  return { CertifyAlone(reference, task), CertifyAlone(result, task) };
}
}
