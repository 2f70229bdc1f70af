// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Decimate.h"

#include "Certificate/Certificate.h"
#include "Collapse/Sweep.h"
#include "Collapse/ThesisLoop.h"
#include "Extract.h"
#include "Measure/SurfaceDistance.h"
#include "Mesh/Checksum.h"
#include "Mesh/SpatialOrder.h"
#include "Mesh/Statistics.h"
#include "Relax/RelaxedLoop.h"
#include "Tolerances.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

namespace bonedecimate
{
namespace
{
using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Where on the way from 0 to 1 each stage ends. Stages that cannot be interrupted are short steps.
constexpr double CleanedAt = 0.01;
constexpr double BuiltAt = 0.02;
constexpr double ExtractionShare = 0.005;
constexpr double BordersShare = 0.02;
constexpr double LastStep = 0.005;

/// One run, stage after stage; remembers whether somebody asked to stop.
class Run
{
public:
  Run(const Surface& input, const Options& options, const Monitor& monitor, bool inputIsSingle,
    bool withOrigins, const std::vector<double>* tolerances)
    : Input(input)
    , Wanted(options)
    , Outer(monitor)
    , RoundToSingle(options.OutputPointsPrecision == PointsPrecision::Single ||
        (options.OutputPointsPrecision == PointsPrecision::Default && inputIsSingle))
    , WithOrigins(withOrigins)
    , Given(tolerances)
  {
    this->Answer.Report.Asked = options;
  }

  Result Go()
  {
    const Clock::time_point start = Clock::now();
    if (this->Prepare())
    {
      this->Collapse();
      this->Answer.Report.Seconds.Decimate = SecondsSince(start);
      this->Measure();
    }
    this->Answer.Report.Seconds.Total = SecondsSince(start);
    return std::move(this->Answer);
  }

private:
  /// A monitor for one stage, whose 0 to 1 is a part of the whole. Once it said stop, it says so for ever.
  Monitor Stage(double from, double to)
  {
    return [this, from, to](double fraction)
    {
      this->Tell(from + fraction * (to - from));
      return this->GoesOn;
    };
  }

  /// Stages may take a large step at once; who listens hears of every hundredth.
  void Tell(double fraction)
  {
    constexpr double hundredth = 0.01;
    while (this->Outer && this->GoesOn && this->Told + hundredth < fraction)
    {
      this->Told += hundredth;
      this->GoesOn = this->Outer(this->Told);
    }
    this->Told = fraction;
    this->GoesOn = this->GoesOn && (!this->Outer || this->Outer(fraction));
  }

  bool Prepare()
  {
    const Clock::time_point start = Clock::now();
    this->Cleaned = Clean(this->Input, this->Wanted.MergePoints, this->Wanted.NumberOfThreads);
    Report& report = this->Answer.Report;
    report.Status = this->Cleaned.Status;
    report.Cleaning = this->Cleaned.Statistics;
    this->Stage(0.0, CleanedAt)(1.0);
    if (report.Status == InputStatus::Good && this->Given != nullptr)
    {
      report.Status = CheckTolerances(
        *this->Given, this->Input.Points.size(), this->Wanted.Mode, report.Cleaning);
    }
    if (report.Status == InputStatus::Good)
    {
      report.InputChecksum = Checksum(this->Input, this->Wanted.NumberOfThreads);
      this->Build();
      this->CountLocked();
    }
    this->Stage(CleanedAt, BuiltAt)(1.0);
    report.Seconds.Prepare = SecondsSince(start);
    return report.Status == InputStatus::Good;
  }

  /// In steps that are short enough for somebody who waits; what nobody needs any more is left out.
  void Build()
  {
    const int threads = this->Wanted.NumberOfThreads;
    const Monitor tell = this->Stage(CleanedAt, BuiltAt);
    if (this->GoesOn)
    {
      SortAlongCurve(this->Cleaned, threads);
    }
    tell(0.25);
    HalfEdgeMesh mesh(this->Cleaned.Surface, threads);
    tell(0.5);
    const bool isThesis = this->Wanted.Mode == Mode::Thesis;
    const Editor::Books books = { isThesis, isThesis, !isThesis && this->GoesOn };
    this->Work.emplace(std::move(mesh), this->Cleaned, books, threads);
    this->Limit();
    tell(0.75);
    if (books.Distances && this->GoesOn)
    {
      this->Work->Reference().Tree(threads, [&] { tell(0.75); });
    }
  }

  /// What has to be proved, and what stays as it is.
  void Limit()
  {
    const std::vector<double> tolerances =
      this->Given != nullptr ? TolerancesOf(this->Cleaned, *this->Given) : std::vector<double>();
    const auto any = [&](auto isSo)
    { return std::any_of(tolerances.begin(), tolerances.end(), isSo); };
    const bool hasError = this->Wanted.MaximumError > 0.0;
    if (this->Wanted.Mode != Mode::Thesis && (hasError || any([](double t) { return t > 0.0; })))
    {
      Promise promise;
      promise.Error = hasError ? this->Wanted.MaximumError : promise.Error;
      promise.RoundsToSingle = this->RoundToSingle;
      promise.Origin = this->Cleaned.Origin;
      promise.Tolerances = tolerances.empty() ? nullptr : &tolerances;
      this->Work->ProveEdits(promise, this->Wanted.NumberOfThreads);
    }
    if (!tolerances.empty())
    {
      this->Answer.Report.Cleaning.FrozenPoints = this->Work->Freeze(tolerances);
      this->IsLimited = !any([](double t) { return t < 0.0; });
    }
  }

  void CountLocked()
  {
    CleaningStatistics& found = this->Answer.Report.Cleaning;
    for (Index v = this->Work->Mesh().NumberOfVertexSlots(); v-- > 0;)
    {
      if (this->Work->Mesh().Kind(v) == VertexKind::Locked)
      {
        ++found.LockedPoints;
        found.FirstLockedPoint = this->Cleaned.InputPoint[v];
      }
    }
  }

  StopReason RunLoop(const Monitor& monitor)
  {
    const Stops stops = StopsOf(this->Wanted, this->Work->Mesh().NumberOfFaces(), this->IsLimited);
    if (this->Wanted.Mode == Mode::Thesis)
    {
      return ThesisLoop(*this->Work, this->Wanted.NormalTolerance, stops).Run(monitor);
    }
    if (this->Wanted.Mode == Mode::Fast)
    {
      return Sweep(*this->Work, stops, this->Wanted.NumberOfThreads).Run(monitor);
    }
    const bool isAccurate = this->Wanted.Mode == Mode::Accurate;
    return RelaxedLoop(*this->Work, isAccurate ? AccurateRecipe : BalancedRecipe, stops,
      this->Wanted.NumberOfThreads)
      .Run(monitor);
  }

  void Collapse()
  {
    const Clock::time_point start = Clock::now();
    Report& report = this->Answer.Report;
    const double collapsedAt = this->MeasuredFrom() - ExtractionShare;
    report.Stop =
      this->GoesOn ? this->RunLoop(this->Stage(BuiltAt, collapsedAt)) : StopReason::Aborted;
    report.Collapses = this->Work->NumberOfEdits();
    report.Refusals = this->Work->Refusals();
    this->Extract(this->Stage(collapsedAt, this->MeasuredFrom()));
    report.RunningError = this->LargestError();
    report.Seconds.Collapse = SecondsSince(start);
  }

  /// Who aborted does not wait for distances.
  void Extract(const Monitor& monitor)
  {
    const int threads = this->Wanted.NumberOfThreads;
    const Original& original = this->Work->Reference();
    const bool distances = this->Wanted.MeasureDistances || original.RecordsDistances();
    const ExtractOptions wanted = { this->RoundToSingle, this->GoesOn && distances,
      this->GoesOn && this->WithOrigins, threads };
    if (wanted.Distances || wanted.Origins)
    {
      original.Tree(threads, [&] { monitor(0.0); });
    }
    this->LocalResult.Points =
      bonedecimate::Extract(this->Input, this->Cleaned, *this->Work, wanted, monitor, this->Answer);
    this->LocalResult.Triangles = this->Answer.Surface.Triangles;
    monitor(1.0);
  }

  /// mm; not a number if nobody looked any point up.
  double LargestError() const
  {
    const std::vector<double>& errors = this->Answer.RunningError;
    if (this->Work->Reference().RecordsDistances())
    {
      return this->Work->Reference().LargestError();
    }
    return errors.empty() ? std::numeric_limits<double>::quiet_NaN()
                          : *std::max_element(errors.begin(), errors.end());
  }

  /// Measuring takes about a third of the time, if there is anything to measure.
  double MeasuredFrom() const
  {
    return this->Wanted.MeasureDistances || this->Wanted.MeasureInputDistances ? 0.7
                                                                               : 1.0 - LastStep;
  }

  void Measure()
  {
    const Clock::time_point start = Clock::now();
    Report& report = this->Answer.Report;
    const SurfaceCounts counts = { static_cast<std::int64_t>(this->Cleaned.Surface.Points.size()),
      this->Work->NumberOfFragments(), this->Work->Mesh().EdgesAtFirst() };
    report.Input = Describe(this->Cleaned.Surface, counts, this->Wanted.NumberOfThreads);
    // Without a collapse the counts of the input hold: flips and moves change none of them.
    report.Output = this->Work->NumberOfEdits() == 0
      ? Describe(this->LocalResult, counts, this->Wanted.NumberOfThreads)
      : Describe(this->LocalResult, this->Wanted.NumberOfThreads);
    if (this->GoesOn && this->MeasuredFrom() < 1.0 - LastStep)
    {
      this->MeasureDistances();
    }
    this->Stage(1.0 - LastStep, 1.0)(1.0);
    report.Stop = this->GoesOn ? report.Stop : StopReason::Aborted;
    report.Seconds.Measure = SecondsSince(start);
  }

  void MeasureDistances()
  {
    const double from = this->MeasuredFrom() + BordersShare;
    const double inputFrom = this->Wanted.MeasureDistances
      ? (this->Wanted.MeasureInputDistances ? 0.9 : 1.0 - LastStep)
      : from;
    const std::int64_t samples = NumberOfSamples(this->Cleaned.Surface.Triangles.size());
    const double backFrom = 0.5 * (from + inputFrom);
    if (this->Wanted.MeasureDistances)
    {
      this->MeasureBorders(this->MeasuredFrom(), from);
      this->Answer.Report.OutputToInput = MeasureDistance(this->LocalResult, this->Answer.Distance,
        this->Work->Reference().Tree(this->Wanted.NumberOfThreads), samples,
        this->Wanted.NumberOfThreads, this->Stage(from, backFrom));
    }
    const Monitor tell = this->Stage(backFrom, backFrom);
    const BoundingTree tree(this->LocalResult, this->Wanted.NumberOfThreads, [&] { tell(1.0); });
    if (this->Wanted.MeasureDistances)
    {
      this->MeasureBack(tree, samples, backFrom, inputFrom);
    }
    if (this->Wanted.MeasureInputDistances)
    {
      this->MeasureInput(tree, inputFrom, 1.0 - LastStep);
    }
  }

  void MeasureBack(const BoundingTree& tree, std::int64_t samples, double from, double to)
  {
    const double pointsAt = from + 0.3 * (to - from);
    const std::vector<double> distances = PointDistances(this->Cleaned.Surface.Points, tree,
      this->Wanted.NumberOfThreads, this->Stage(from, pointsAt));
    this->Answer.Report.InputToOutput = MeasureDistance(this->Cleaned.Surface, distances, tree,
      samples, this->Wanted.NumberOfThreads, this->Stage(pointsAt, to));
    this->Answer.Report.DistancesMeasured = this->GoesOn;
  }

  /// Curve to curve. A border cannot vanish, but without merged points there is one about each triangle.
  void MeasureBorders(double from, double to)
  {
    CertificateOptions options;
    options.WithSurfaces = false;
    options.NumberOfThreads = this->Wanted.NumberOfThreads;
    const Certificate found =
      Certify(this->Cleaned.Surface, this->LocalResult, options, this->Stage(from, to));
    Report& report = this->Answer.Report;
    report.BordersMeasured =
      found.Status == CertificateStatus::Good && found.Borders == BorderPresence::Both;
    if (report.BordersMeasured)
    {
      const DistanceBounds& back = found.BorderOfResultToReference.Distance;
      const DistanceBounds& there = found.BorderOfReferenceToResult.Distance;
      report.BorderOutputToInput = { back.Lower, back.Upper };
      report.BorderInputToOutput = { there.Lower, there.Upper };
    }
  }

  /// Points that no triangle uses are measured like the others.
  void MeasureInput(const BoundingTree& tree, double from, double to)
  {
    std::vector<Vector3> local;
    local.reserve(this->Input.Points.size());
    for (const Vector3& point : this->Input.Points)
    {
      local.push_back(point - this->Cleaned.Origin);
    }
    this->Answer.InputDistance =
      PointDistances(local, tree, this->Wanted.NumberOfThreads, this->Stage(from, to));
  }

  const Surface& Input;
  const Options& Wanted;
  const Monitor& Outer;
  bool RoundToSingle;
  bool WithOrigins;
  const std::vector<double>* Given; // mm, tolerances of the input points
  bool IsLimited = false;           // whether every point has a tolerance
  bool GoesOn = true;
  double Told = 0.0;
  CleanSurface Cleaned;
  std::optional<Editor> Work;
  Surface LocalResult; // mm relative to Cleaned.Origin
  Result Answer;
};
}

Result Decimate(const Surface& input, const Options& options, const Monitor& monitor,
  bool inputIsSingle, bool withOrigins, const std::vector<double>* tolerances)
{
  return Run(input, options, monitor, inputIsSingle, withOrigins, tolerances).Go();
}
}
