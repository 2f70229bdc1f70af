// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Judgement.h"

#include "Certificate/Certificate.h"
#include "Clearance/Gaps.h"
#include "Measure/SurfaceDistance.h"
#include "Mesh/Sheets.h"
#include "Mesh/Statistics.h"
#include "StageClock.h"

#include <utility>

namespace bonedecimate
{
namespace
{
/// Shares of the whole progress.
constexpr double BordersShare = 0.02;
constexpr double InputPointsShare = 0.095;
constexpr double LastStep = 0.005;

/// The steps of Judge(), one after the other.
class Judgement
{
public:
  Judgement(const JudgedRun& run, const Options& options, RunProgress& progress, Result& answer)
    : Run(run)
    , Wanted(options)
    , Progress(progress)
    , Answer(answer)
    , MeasuredAt(MeasuredTo(run.IsProvedNext) - LastStep)
  {
  }

  void DescribeSurfaces()
  {
    const int threads = this->Wanted.NumberOfThreads;
    const Editor& work = this->Run.Work;
    const SurfaceCounts counts = { NumberOfSites(this->Run.Cleaned), work.NumberOfFragments(),
      work.Mesh().EdgesAtFirst() };
    Report& report = this->Answer.Report;
    report.Input = Describe(this->Run.Cleaned.Surface, counts, threads);
    // Without a collapse the counts of the input hold: flips and moves change none of them.
    report.Output = work.NumberOfEdits() == 0 ? Describe(this->Run.LocalResult, counts, threads)
                                              : Describe(this->Run.LocalResult, threads);
  }

  void MeasureDistances()
  {
    const double measuredFrom = MeasuredFrom(this->Wanted, this->Run.IsProvedNext);
    const double from = measuredFrom + BordersShare;
    const double inputFrom = !this->Wanted.MeasureDistances ? from
      : this->Wanted.MeasureInputDistances                  ? this->MeasuredAt - InputPointsShare
                                                            : this->MeasuredAt;
    const Surface& original = this->Original();
    const std::int64_t samples = NumberOfSamples(original.Triangles.size());
    const double backFrom = 0.5 * (from + inputFrom);
    if (this->Wanted.MeasureDistances)
    {
      if (!this->Run.IsProvedNext)
      {
        this->MeasureBorders(measuredFrom, from);
      }
      this->MeasureThere(samples, from, backFrom);
    }
    const Monitor tell = this->Progress.Stage(backFrom, backFrom);
    const BoundingTree tree(
      this->Run.LocalResult, this->Wanted.NumberOfThreads, [&] { tell(1.0); });
    if (this->Wanted.MeasureDistances)
    {
      this->MeasureBack(original, tree, samples, backFrom, inputFrom);
    }
    if (this->Wanted.MeasureInputDistances)
    {
      this->MeasureInput(tree, inputFrom, this->MeasuredAt);
    }
  }

  /// Between fragments.
  void MeasureClearance()
  {
    Report& report = this->Answer.Report;
    if (report.Input.Components > 1)
    {
      report.Clearance = { WithJoined(this->Run.Cleaned, LeastClearance),
        LeastClearance(this->Run.LocalResult) };
      report.ClearanceMeasured = true;
    }
  }

private:
  /// What distances are measured to; relative to Cleaned.Origin.
  const Surface& Original()
  {
    if (this->Run.Reference == nullptr)
    {
      return this->Run.Cleaned.Surface;
    }
    CleanSurface clean =
      Clean(*this->Run.Reference, this->Wanted.MergePoints, this->Wanted.NumberOfThreads);
    this->LocalReference = std::move(clean.Surface);
    for (Vector3& p : this->LocalReference.Points)
    {
      p += clean.Origin - this->Run.Cleaned.Origin;
    }
    return this->LocalReference;
  }

  void MeasureThere(std::int64_t samples, double from, double to)
  {
    const int threads = this->Wanted.NumberOfThreads;
    const Monitor tell = this->Progress.Stage(from, to);
    const auto measure = [&](const BoundingTree& tree)
    {
      return MeasureDistance(
        this->Run.LocalResult, this->Answer.Distance, tree, samples, threads, tell);
    };
    if (this->Run.Reference == nullptr)
    {
      this->Answer.Report.OutputToInput = measure(this->Run.Work.Reference().Tree(threads));
      return;
    }
    const BoundingTree tree(this->LocalReference, threads);
    this->Answer.Distance =
      PointDistances(this->Run.LocalResult.Points, tree, threads, this->Progress.Stage(from, from));
    if (this->Progress.GoesOn())
    {
      this->Answer.Report.OutputToInput = measure(tree);
    }
  }

  void MeasureBack(
    const Surface& original, const BoundingTree& tree, std::int64_t samples, double from, double to)
  {
    const double pointsAt = from + 0.3 * (to - from);
    const std::vector<double> distances = PointDistances(
      original.Points, tree, this->Wanted.NumberOfThreads, this->Progress.Stage(from, pointsAt));
    this->Answer.Report.InputToOutput = MeasureDistance(original, distances, tree, samples,
      this->Wanted.NumberOfThreads, this->Progress.Stage(pointsAt, to));
    this->Answer.Report.DistancesMeasured = this->Progress.GoesOn();
  }

  /// Curve to curve. A border cannot vanish, but without merged points there is one about each triangle.
  void MeasureBorders(double from, double to)
  {
    CertificateOptions options;
    options.WithSurfaces = false;
    options.NumberOfThreads = this->Wanted.NumberOfThreads;
    const Certificate found = Certify(
      this->Run.Cleaned.Surface, this->Run.LocalResult, options, this->Progress.Stage(from, to));
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
    local.reserve(this->Run.Input.Points.size());
    for (const Vector3& point : this->Run.Input.Points)
    {
      local.push_back(point - this->Run.Cleaned.Origin);
    }
    this->Answer.InputDistance =
      PointDistances(local, tree, this->Wanted.NumberOfThreads, this->Progress.Stage(from, to));
  }

  const JudgedRun& Run;
  const Options& Wanted;
  RunProgress& Progress;
  Result& Answer;
  Surface LocalReference;
  double MeasuredAt; // where on the way from 0 to 1 it ends
};
}

/// Measuring takes about a third of the time, if there is anything to measure; the proof a tenth.
double MeasuredFrom(const Options& options, bool isProvedNext)
{
  const bool measures = options.MeasureDistances || options.MeasureInputDistances;
  return MeasuredTo(isProvedNext) - (measures ? 0.3 : LastStep);
}

double MeasuredTo(bool isProvedNext)
{
  return isProvedNext ? 0.9 : 1.0;
}

void Judge(const JudgedRun& run, const Options& options, RunProgress& progress, Result& answer)
{
  const StageClock clock;
  Judgement judgement(run, options, progress, answer);
  judgement.DescribeSurfaces();
  if (progress.GoesOn() && (options.MeasureDistances || options.MeasureInputDistances))
  {
    judgement.MeasureDistances();
  }
  if (progress.GoesOn() && options.MeasureDistances)
  {
    judgement.MeasureClearance();
  }
  const double end = MeasuredTo(run.IsProvedNext);
  progress.Stage(end - LastStep, end)(1.0);
  answer.Report.Seconds.Measure = clock.Seconds();
}
}
