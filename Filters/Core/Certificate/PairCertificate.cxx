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

namespace bonedecimate::certificate
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::int64_t LeastMostCuts = std::int64_t{ 1 } << 26;
constexpr std::int64_t CutsASimplex = 16;
/// The least gap that is looked for, 1e-9 of the extent, and the least that can be found: both bounds err by a slack.
constexpr double SlacksOfGap = 2048.0;
constexpr double FewestSlacks = 4.0;

CertificateVerdict Judge(const DistanceBounds& bounds, double tolerance)
{
  return bounds.Upper <= tolerance ? CertificateVerdict::Proved
    : bounds.Lower > tolerance     ? CertificateVerdict::Violated
                                   : CertificateVerdict::Undecided;
}

/// The best of two searches.
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

/// One direction; the target's tolerances are those of the excess.
class Direction
{
public:
  /// @param triangleGap mm, of the bounds of single triangles; 0: none are wanted.
  Direction(const Simplices& source, const Target& target, const PairTask& task, double triangleGap)
    : Source(source)
    , To(target)
    , Task(task)
    , TriangleGap(task.OfSurfaces ? triangleGap : 0.0)
  {
    const std::int64_t asked = task.Options.MostCuts;
    this->Goal.MostCuts =
      asked > 0 ? asked : LeastMostCuts + CutsASimplex * static_cast<std::int64_t>(source.Size());
    this->Goal.RelativeGap = task.Options.RelativeGap;
    this->Goal.Slack = task.Slack;
    this->Goal.LeastGap = std::max(SlacksOfGap * task.Slack, task.Options.LeastGap);
    this->Goal.NumberOfThreads = task.Options.NumberOfThreads;
  }

  void FindDistance(DirectedCertificate& answer, Stages& progress, double share)
  {
    const std::optional<double>& tolerance = this->Task.Options.Tolerance;
    const bool stopAtTolerance = tolerance && !this->Task.Options.TightBounds;
    this->Goal.CloseBelow = stopAtTolerance ? *tolerance : -Infinity;
    const PointValues values = this->Values(progress, 0.4 * share);
    if (progress.GoesOn())
    {
      answer.Distance = this->Find(values, progress.Next(0.4 * share));
    }
    if (tolerance && progress.GoesOn())
    {
      this->Decide(*tolerance, values, answer, progress);
    }
    if (this->TriangleGap > 0.0 && progress.GoesOn())
    {
      this->BoundTriangles(values, answer, progress.Next(0.1 * share));
    }
    if (this->Task.OfSurfaces && progress.GoesOn())
    {
      this->Describe(values, answer, progress.Next(0.1 * share));
    }
  }

  void FindExcess(
    DirectedCertificate& answer, double largestTolerance, Stages& progress, double share)
  {
    this->Goal.CloseBelow = 0.0;
    this->Goal.Scale = largestTolerance;
    const PointValues values = this->Values(progress, 0.5 * share);
    if (progress.GoesOn())
    {
      answer.Excess = this->Find(values, progress.Next(0.5 * share));
      answer.Verdict = Judge(answer.Excess, 0.0);
    }
    if (answer.Verdict == CertificateVerdict::Undecided && progress.GoesOn())
    {
      // What did not move, with a tolerance of 0, has an excess of exactly 0: no gap is allowed above it.
      this->Goal.Decides = true;
      Tighten(answer.Excess, this->Find(values, progress.Next(0.0)));
      answer.Verdict = Judge(answer.Excess, 0.0);
    }
  }

private:
  PointValues Values(Stages& progress, double share) const
  {
    return FindPointValues(this->Source, this->To,
      this->Task.OfSurfaces && this->Task.Options.WithPointDistances, this->Goal.NumberOfThreads,
      progress.Next(share));
  }

  /// Once more, if the tolerance lies in the gap.
  void Decide(
    double tolerance, const PointValues& values, DirectedCertificate& answer, Stages& progress)
  {
    answer.Verdict = Judge(answer.Distance, tolerance);
    if (answer.Verdict == CertificateVerdict::Undecided)
    {
      this->Goal.CloseBelow = tolerance;
      this->Goal.RelativeGap = 0.0;
      this->Goal.LeastGap = FewestSlacks * this->Goal.Slack;
      Tighten(answer.Distance, this->Find(values, progress.Next(0.0)));
      answer.Verdict = Judge(answer.Distance, tolerance);
    }
  }

  void BoundTriangles(
    const PointValues& values, DirectedCertificate& answer, const Monitor& monitor) const
  {
    SearchGoal goal = this->Goal;
    goal.CloseBelow = -Infinity;
    goal.RelativeGap = 0.0;
    goal.LeastGap = std::max(this->TriangleGap, FewestSlacks * goal.Slack);
    answer.TriangleUpper =
      FindTriangleBounds(this->Source, this->To, values, goal, answer.Distance.Upper, monitor);
  }

  void Describe(const PointValues& values, DirectedCertificate& answer, const Monitor& monitor)
  {
    const CertificateOptions& options = this->Task.Options;
    if (options.WithMeans)
    {
      answer.Mean = FindMeanDistance(
        this->Source, this->To, values, options.MeanPrecision, this->Goal.NumberOfThreads, monitor);
    }
    if (options.WithPointDistances)
    {
      answer.Points.Distance = values.Value;
      answer.Points.Side =
        FindSides(this->Source.Points, values.Simplex, this->To.All(), this->Goal.NumberOfThreads);
    }
  }

  DistanceBounds Find(const PointValues& values, const Monitor& monitor) const
  {
    return FindLargestExcess(this->Source, this->To, values, this->Goal, monitor);
  }

  const Simplices& Source;
  const Target& To;
  const PairTask& Task;
  double TriangleGap; // mm
  SearchGoal Goal;
};

/// mm, the least of the corners of each simplex.
std::vector<double> LeastLimits(const Simplices& simplices, const std::vector<double>& limit)
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

double LargestFinite(const std::vector<double>& limits)
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

/// Where nothing limits.
void Allow(DirectedCertificate& answer)
{
  answer.Excess.Upper = -Infinity;
  answer.Verdict = CertificateVerdict::Proved;
}

/// The pair, the limits and the shares of progress of one comparison.
struct Comparison
{
  const Simplices& Reference;
  const Simplices& Result;
  const std::vector<double>& Limit;
  const PairTask& Task;
  Stages& Progress;
  double Share; // of one search
};

DirectedCertificate Forward(const Comparison& both)
{
  DirectedCertificate answer;
  const Monitor tell = both.Progress.Next(0.0);
  const Target target(both.Result, both.Task.Options.NumberOfThreads, [&] { tell(1.0); });
  Direction(both.Reference, target, both.Task, both.Task.Options.ReferenceTriangleGap)
    .FindDistance(answer, both.Progress, both.Share);
  NameTriangles(answer.Distance, both.Reference, both.Result);
  if (both.Limit.empty() || !both.Progress.GoesOn())
  {
    return answer;
  }
  const Simplices limited = LimitedPart(both.Reference, both.Limit);
  if (limited.Size() == 0)
  {
    Allow(answer);
    return answer;
  }
  Direction(limited, target, both.Task, 0.0)
    .FindExcess(answer, LargestFinite(both.Limit), both.Progress, both.Share);
  NameTriangles(answer.Excess, limited, both.Result);
  return answer;
}

DirectedCertificate Backward(const Comparison& both)
{
  DirectedCertificate answer;
  const Monitor tell = both.Progress.Next(0.0);
  Target target(both.Reference, both.Task.Options.NumberOfThreads, [&] { tell(1.0); });
  Direction(both.Result, target, both.Task, both.Task.Options.ResultTriangleGap)
    .FindDistance(answer, both.Progress, both.Share);
  NameTriangles(answer.Distance, both.Result, both.Reference);
  if (both.Limit.empty() || !both.Progress.GoesOn())
  {
    return answer;
  }
  std::vector<double> least = LeastLimits(both.Reference, both.Limit);
  const double largest = *std::max_element(least.begin(), least.end());
  if (!std::isfinite(largest))
  {
    Allow(answer);
    return answer;
  }
  target.SetTolerances(std::move(least));
  Direction(both.Result, target, both.Task, 0.0)
    .FindExcess(answer, largest, both.Progress, both.Share);
  NameTriangles(answer.Excess, both.Result, both.Reference);
  return answer;
}

DirectedCertificate Alone(const BorderSet& source, const PairTask& task)
{
  DirectedCertificate answer;
  const bool isEmpty = source.Segments.Size() == 0;
  answer.Distance.Lower = answer.Distance.Upper = isEmpty ? 0.0 : Infinity;
  answer.Distance.Triangle = isEmpty ? None : source.Segments.TriangleId(0);
  answer.Distance.Place = isEmpty ? Vector3::Zero() : source.Segments.Points[0];
  if (!task.Options.ToleranceMap.empty() || task.Options.Tolerance)
  {
    const bool isFree = isEmpty ||
      (!source.Limit.empty() &&
        std::none_of(source.Limit.begin(), source.Limit.end(),
          [](double limit) { return std::isfinite(limit); }));
    answer.Excess = answer.Distance;
    answer.Excess.Upper = answer.Excess.Lower = isFree ? -Infinity : Infinity;
    answer.Verdict = isFree ? CertificateVerdict::Proved : CertificateVerdict::Violated;
  }
  return answer;
}
}

//------------------------------------------------------------------------------
PairCertificate CertifyPair(const Simplices& reference, const Simplices& result,
  const std::vector<double>& limit, const PairTask& task, Stages& progress, double share)
{
  const double part = limit.empty() ? 0.5 * share : 0.25 * share;
  const Comparison both = { reference, result, limit, task, progress, part };
  PairCertificate answer;
  answer.ReferenceToResult = Forward(both);
  if (progress.GoesOn())
  {
    answer.ResultToReference = Backward(both);
  }
  return answer;
}

//------------------------------------------------------------------------------
PairCertificate WithoutPartner(
  const BorderSet& reference, const BorderSet& result, const PairTask& task)
{
  return { Alone(reference, task), Alone(result, task) };
}
}
