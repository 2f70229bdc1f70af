// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation.h"

#include "Base/Parallel.h"
#include "Base/StageClock.h"
#include "CompareShapes.h"
#include "Mesh/ManifoldPatches.h"
#include "Mesh/Statistics.h"
#include "PartComparison.h"
#include "Proof/Certificate/Certificate.h"
#include "Proof/Guard/GapRule.h"
#include "Proof/Measure/SurfaceDistance.h"
#include "Run/Input/EdgeLengths.h"
#include "Run/Input/LabelMapInput.h"

#include <Eigen/Geometry>

#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Parts of the whole progress.
constexpr double BoundariesProgress = 0.02;
constexpr double InputPointsProgress = 0.095;
constexpr double LastStep = 0.005;

/// mm^3, what triangles between two labels add to the sum over all triangles. In the sum over all
/// labels each of them counts once with either sign, that is not at all.
double VolumeOfWalls(const Surface& surface, const std::vector<BoundaryLabels>& pairs,
  const LabelMapSource& map, int threads)
{
  return SumOverBlocks(pairs.size(), threads,
    [&](std::size_t first, std::size_t last)
    {
      double volume = 0.0;
      for (std::size_t t = first; t < last; ++t)
      {
        const Triangle& c = surface.Triangles[t];
        const Vector3& p = surface.Points[c[0]];
        volume += pairs[t][1] == map.Background()
          ? 0.0
          : Dot((surface.Points[c[1]] - p).cross(surface.Points[c[2]] - p), p) / 6.0;
      }
      return volume;
    });
}

/// The steps of Evaluate(), one after the other.
class Evaluator
{
public:
  Evaluator(const EvaluatedRun& run, const Options& options, RunProgress& progress, Result& output)
    : Run(run)
    , Requested(options)
    , Progress(progress)
    , Output(output)
    , MeasuredAt(MeasuredTo(run.CertificateFollows) - LastStep)
  {
  }

  void DescribeSurfaces()
  {
    const int threads = this->Requested.NumberOfThreads;
    const Editor& editor = this->Run.MeshEditor;
    const SurfaceCounts counts = { NumberOfOriginalVertices(this->Run.Cleaned),
      editor.Components().Count(), editor.Mesh().InitialEdgeCounts() };
    Report& report = this->Output.Report;
    report.Input = Describe(this->Run.Cleaned.Surface, counts, threads);
    // Without a collapse the counts of the input hold: flips and moves change none of them.
    report.Output = editor.Totals().Collapses == 0
      ? Describe(this->Run.LocalResult, counts, threads)
      : Describe(this->Run.LocalResult, threads);
    CompareShapes(this->Output.Surface, this->Requested,
      ShapeLimitsOf(this->Requested, this->Run.Sizes), this->Run.Cleaned.Origin, report);
    if (const LabelMapSource* map = this->Run.Inputs.LabelMap)
    {
      report.Input.Volume -= VolumeOfWalls(
        this->Run.Cleaned.Surface, BoundaryLabelsOf(this->Run.Cleaned, *map), *map, threads);
      report.Output.Volume -=
        VolumeOfWalls(this->Run.LocalResult, this->Output.BoundaryLabels, *map, threads);
    }
    if (this->Run.MinPart > 0.0)
    {
      this->Parts.emplace(this->Run.Cleaned, this->Run.Inputs);
      report.Parts = this->Parts->Compare(editor.Mesh(), this->Run.LocalResult, this->Run.MinPart);
    }
  }

  void MeasureDistances()
  {
    const double measuredFrom = MeasuredFrom(this->Requested, this->Run.CertificateFollows);
    const double from = measuredFrom + BoundariesProgress;
    const double inputFrom = !this->Requested.MeasureDistances ? from
      : this->Requested.MeasureInputDistances ? this->MeasuredAt - InputPointsProgress
                                              : this->MeasuredAt;
    const Surface& original = this->Original();
    const std::int64_t samples = NumberOfSamples(original.Triangles.size());
    const double backFrom = 0.5 * (from + inputFrom);
    if (this->Requested.MeasureDistances)
    {
      if (!this->Run.CertificateFollows)
      {
        this->MeasureBoundaries(measuredFrom, from);
      }
      this->MeasureThere(samples, from, backFrom);
    }
    const Monitor tell = this->Progress.Stage(backFrom, backFrom);
    const BoundingTree tree(
      this->Run.LocalResult, this->Requested.NumberOfThreads, [&] { tell(1.0); });
    if (this->Requested.MeasureDistances)
    {
      this->MeasureBack(original, tree, samples, backFrom, inputFrom);
      this->MeasureThickness(tree);
    }
    if (this->Requested.MeasureInputDistances)
    {
      this->MeasureInput(tree, inputFrom, this->MeasuredAt);
    }
  }

  /// Measures the gap between fragments.
  void MeasureFragmentGap()
  {
    Report& report = this->Output.Report;
    if (report.Input.Components > 1)
    {
      report.Gap = { WithJoined(this->Run.Cleaned, MinFragmentGap),
        MinFragmentGap(this->Run.LocalResult) };
      report.FragmentGapMeasured = true;
    }
  }

private:
  /// The surface to which distances are measured, relative to Cleaned.Origin.
  const Surface& Original()
  {
    if (this->Run.Reference == nullptr)
    {
      return this->Run.Cleaned.Surface;
    }
    CleanSurface clean =
      Clean(*this->Run.Reference, this->Requested.MergePoints, this->Requested.NumberOfThreads);
    this->LocalReference = std::move(clean.Surface);
    for (Vector3& p : this->LocalReference.Points)
    {
      p += clean.Origin - this->Run.Cleaned.Origin;
    }
    return this->LocalReference;
  }

  /// With the position in the coordinates of the input.
  DistanceStatistics InFile(DistanceStatistics statistics) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      statistics.MaximumAt[axis] += this->Run.Cleaned.Origin[static_cast<int>(axis)];
    }
    return statistics;
  }

  void MeasureThere(std::int64_t samples, double from, double to)
  {
    const int threads = this->Requested.NumberOfThreads;
    const Monitor tell = this->Progress.Stage(from, to);
    const auto measure = [&](const BoundingTree& tree)
    {
      return this->InFile(MeasureDistance(
        this->Run.LocalResult, this->Output.Distance, tree, samples, threads, tell));
    };
    if (this->Run.Reference == nullptr)
    {
      this->Output.Report.OutputToInput = measure(this->Run.MeshEditor.Original().Tree(threads));
      return;
    }
    const BoundingTree tree(this->LocalReference, threads);
    this->Output.Distance =
      PointDistances(this->Run.LocalResult.Points, tree, threads, this->Progress.Stage(from, from));
    if (this->Progress.ShouldContinue())
    {
      this->Output.Report.OutputToInput = measure(tree);
    }
  }

  void MeasureBack(
    const Surface& original, const BoundingTree& tree, std::int64_t samples, double from, double to)
  {
    const double pointsAt = from + 0.3 * (to - from);
    const std::vector<double> distances = PointDistances(
      original.Points, tree, this->Requested.NumberOfThreads, this->Progress.Stage(from, pointsAt));
    this->Output.Report.InputToOutput = this->InFile(MeasureDistance(original, distances, tree,
      samples, this->Requested.NumberOfThreads, this->Progress.Stage(pointsAt, to)));
    this->Output.Report.DistancesMeasured = this->Progress.ShouldContinue();
  }

  void MeasureThickness(const BoundingTree& tree)
  {
    const int threads = this->Requested.NumberOfThreads;
    if (this->Parts && this->Progress.ShouldContinue())
    {
      this->Parts->MeasureThickness(this->Run.MeshEditor.Original().Tree(threads), tree,
        this->Run.LocalResult, threads, this->Output.Report.Parts);
    }
  }

  /// Curve to curve. Skipped without MergePoints, where every triangle has a boundary of its own.
  void MeasureBoundaries(double from, double to)
  {
    CertificateOptions options;
    options.WithSurfaces = false;
    options.NumberOfThreads = this->Requested.NumberOfThreads;
    const Certificate found = Certify(
      this->Run.Cleaned.Surface, this->Run.LocalResult, options, this->Progress.Stage(from, to));
    Report& report = this->Output.Report;
    report.BoundariesMeasured =
      found.Status == CertificateStatus::Good && found.Boundaries == BoundaryPresence::Both;
    if (report.BoundariesMeasured)
    {
      const DistanceBounds& back = found.BoundaryOfResultToReference.Distance;
      const DistanceBounds& there = found.BoundaryOfReferenceToResult.Distance;
      report.BoundaryOutputToInput = { back.Lower, back.Upper };
      report.BoundaryInputToOutput = { there.Lower, there.Upper };
    }
  }

  /// Includes points that no triangle uses.
  void MeasureInput(const BoundingTree& tree, double from, double to)
  {
    std::vector<Vector3> local;
    local.reserve(this->Run.Input.Points.size());
    for (const Vector3& point : this->Run.Input.Points)
    {
      local.push_back(point - this->Run.Cleaned.Origin);
    }
    this->Output.InputDistance =
      PointDistances(local, tree, this->Requested.NumberOfThreads, this->Progress.Stage(from, to));
  }

  const EvaluatedRun& Run;
  const Options& Requested;
  RunProgress& Progress;
  Result& Output;
  Surface LocalReference;
  std::optional<PartComparer> Parts;
  double MeasuredAt; // progress at its end, 0 to 1
};
}

/// Measuring takes about a third of the time of a run, the proof a tenth.
double MeasuredFrom(const Options& options, bool isProvedNext)
{
  const bool measures = options.MeasureDistances || options.MeasureInputDistances;
  return MeasuredTo(isProvedNext) - (measures ? 0.3 : LastStep);
}

double MeasuredTo(bool isProvedNext)
{
  return isProvedNext ? 0.9 : 1.0;
}

void Evaluate(
  const EvaluatedRun& run, const Options& options, RunProgress& progress, Result& output)
{
  const StageClock clock;
  Evaluator evaluator(run, options, progress, output);
  evaluator.DescribeSurfaces();
  if (progress.ShouldContinue() && (options.MeasureDistances || options.MeasureInputDistances))
  {
    evaluator.MeasureDistances();
  }
  if (progress.ShouldContinue() && options.MeasureDistances)
  {
    evaluator.MeasureFragmentGap();
  }
  const double end = MeasuredTo(run.CertificateFollows);
  progress.Stage(end - LastStep, end)(1.0);
  output.Report.Seconds.Measure = clock.Seconds();
}
}
