// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionReport.h"

#include "Geometry/TriangleGeometry.h"
#include "Mesh/TriangleShapes.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Input/EdgeLengths.h"
#include "Run/Output/CompareShapes.h"
#include "Run/Report/MergeReports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace bonedecimate
{
namespace
{
/// The same as FragmentGuard keeps; it sees a component that is cut as an open one.
constexpr double MinVolumeRatio = 0.25;

SurfaceStatistics StatisticsOfResult(const WholeSurface& whole, const RegionParts& parts,
  const std::map<Index, ExtentChange>& changes, const Surface& surface, int threads)
{
  SurfaceStatistics output = whole.Statistics;
  output.Faces = static_cast<std::int64_t>(surface.Triangles.size());
  output.Points = static_cast<std::int64_t>(surface.Points.size());
  for (const auto& part : parts)
  {
    const SurfaceStatistics& before = part->Result.Report.Input;
    const SurfaceStatistics& after = part->Result.Report.Output;
    output.BoundaryEdges += after.BoundaryEdges - before.BoundaryEdges;
    output.NonManifoldEdges += after.NonManifoldEdges - before.NonManifoldEdges;
    output.EulerNumber += after.EulerNumber - before.EulerNumber;
  }
  output.Shape = DescribeShapes(surface, threads);
  for (const auto& change : changes)
  {
    output.Area += change.second.Area;
    output.Volume += change.second.Volume;
  }
  return output;
}

/// The mean; 0 for a surface without area or points.
double Ratio(double sum, double of)
{
  return of > 0.0 ? sum / of : 0.0;
}

/// Members of a part's report for one direction.
struct Direction
{
  DistanceStatistics Report::*Distance;
  SurfaceStatistics Report::*Measured; // on which the samples lie
};

DistanceStatistics CombineDistances(
  const SurfaceStatistics& measured, const RegionParts& parts, const Direction& direction)
{
  DistanceStatistics all;
  std::vector<double> largest = { 0.0, 0.0 };
  double area = 0.0;
  double squares = 0.0;
  double pointSquares = 0.0;
  for (const auto& part : parts)
  {
    const DistanceStatistics& one = part->Result.Report.*direction.Distance;
    const SurfaceStatistics& of = part->Result.Report.*direction.Measured;
    const auto points = static_cast<double>(of.Points);
    if (one.Maximum >= all.Maximum)
    {
      all.Maximum = one.Maximum;
      all.MaximumAt = one.MaximumAt;
    }
    all.Mean += one.Mean * of.Area;
    squares += one.RootMeanSquare * one.RootMeanSquare * of.Area;
    all.PointMean += one.PointMean * points;
    pointSquares += one.PointRootMeanSquare * one.PointRootMeanSquare * points;
    all.Samples += one.Samples;
    area += of.Area;
    largest.push_back(one.PointMaximum);
    largest.push_back(one.Second);
  }
  std::sort(largest.begin(), largest.end(), std::greater<>());
  all.PointMaximum = largest[0];
  all.Second = largest[1];
  const auto allPoints = static_cast<double>(measured.Points);
  all.Mean = Ratio(all.Mean, measured.Area);
  all.RootMeanSquare = std::sqrt(Ratio(squares, measured.Area));
  all.PointMean = Ratio(all.PointMean, allPoints);
  all.PointRootMeanSquare = std::sqrt(Ratio(pointSquares, allPoints));
  all.SamplesPerSquareMillimeter = Ratio(static_cast<double>(all.Samples), area);
  return all;
}

void CombineMeasured(const RegionParts& parts, Report& report)
{
  report.DistancesMeasured = std::all_of(parts.begin(), parts.end(),
    [](const auto& part) { return part->Result.Report.DistancesMeasured; });
  if (!report.DistancesMeasured)
  {
    return;
  }
  report.OutputToInput =
    CombineDistances(report.Output, parts, { &Report::OutputToInput, &Report::Output });
  report.InputToOutput =
    CombineDistances(report.Input, parts, { &Report::InputToOutput, &Report::Input });
  // others are not compared
  report.BoundariesMeasured = report.Input.BoundaryEdges > 0 && report.Requested.MergePoints;
}

/// The largest bounds. Beyond the reach of a part there is more of the surface, so that a lower
/// bound ends there.
ProvedDistance MaxBounds(
  const RegionParts& parts, const std::function<ProvedDistance(const Report&)>& boundsOf)
{
  ProvedDistance largest;
  for (const auto& part : parts)
  {
    const ProvedDistance one = boundsOf(part->Result.Report);
    largest.Lower = std::max(largest.Lower, std::min(one.Lower, part->Covered.Reach));
    largest.Upper = std::max(largest.Upper, one.Upper);
  }
  return largest;
}

void CombineProofs(const RegionParts& parts, Report& report)
{
  ErrorProof& proof = report.Proof;
  proof.WasMade = true;
  proof.Status = ProofStatus::Proved;
  proof.Tolerance = report.Requested.BoundsError() ? report.Size.ErrorBound : 0.0;
  proof.InputToOutput =
    MaxBounds(parts, [](const Report& part) { return part.Proof.InputToOutput; });
  proof.OutputToInput =
    MaxBounds(parts, [](const Report& part) { return part.Proof.OutputToInput; });
  proof.BoundariesCompared = report.Requested.MergePoints;
  if (proof.BoundariesCompared && report.Input.BoundaryEdges > 0)
  {
    proof.Boundaries = BoundaryPresence::Both;
    proof.BoundaryInputToOutput =
      MaxBounds(parts, [](const Report& part) { return part.Proof.BoundaryInputToOutput; });
    proof.BoundaryOutputToInput =
      MaxBounds(parts, [](const Report& part) { return part.Proof.BoundaryOutputToInput; });
  }
}

}

bool ArePartsValid(const WholeSurface& whole, const RegionParts& parts,
  const std::map<Index, ExtentChange>& changes, bool wantsProof)
{
  const bool areProved = !wantsProof ||
    std::all_of(parts.begin(), parts.end(),
      [](const auto& part)
      {
        const ErrorProof& proof = part->Result.Report.Proof;
        const double surface = std::max(proof.InputToOutput.Upper, proof.OutputToInput.Upper);
        // Where the part was cut it has boundaries that the surface lacks: none of them is near
        // enough to count.
        return proof.WasMade && proof.Status == ProofStatus::Proved &&
          proof.Upper() + surface < part->Covered.Reach;
      });
  return areProved &&
    std::all_of(changes.begin(), changes.end(),
      [&](const auto& change)
      {
        const PartExtent& before = whole.Extents[change.first];
        const double after = (before.Volume + change.second.Volume) / before.Volume;
        return !before.IsClosed || before.Volume == 0.0 || after >= MinVolumeRatio;
      });
}

void CombineReports(const WholeSurface& whole, const RegionParts& parts,
  const std::map<Index, ExtentChange>& changes, bool wantsProof, Result& result)
{
  Report& report = result.Report;
  report.Input = whole.Statistics;
  report.Output =
    StatisticsOfResult(whole, parts, changes, result.Surface, report.Requested.NumberOfThreads);
  CompareShapes(
    result.Surface, report.Requested, ShapeLimitsOf(report.Requested), Vector3::Zero(), report);
  report.InputChecksum = whole.Checksum;
  report.RunningError = result.Distance.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  report.Stop = StopReason::NothingLeft;
  for (const auto& part : parts)
  {
    report.Stop = part->Result.Report.Stop;
    AddPart(part->Result.Report, report);
  }
  if (report.Requested.MeasureDistances)
  {
    CombineMeasured(parts, report);
  }
  if (wantsProof)
  {
    CombineProofs(parts, report);
    report.BoundaryInputToOutput = report.Proof.BoundaryInputToOutput;
    report.BoundaryOutputToInput = report.Proof.BoundaryOutputToInput;
  }
  else if (report.BoundariesMeasured)
  {
    report.BoundaryInputToOutput =
      MaxBounds(parts, [](const Report& part) { return part.BoundaryInputToOutput; });
    report.BoundaryOutputToInput =
      MaxBounds(parts, [](const Report& part) { return part.BoundaryOutputToInput; });
  }
}

std::vector<LabelArea> AreasOfLabels(
  const WholeSurface& whole, const RegionParts& parts, const Labels& labels)
{
  std::vector<LabelArea> areas;
  areas.reserve(labels.Names.size());
  for (const std::string& name : labels.Names)
  {
    areas.push_back({ name, 0.0, 0.0 });
  }
  const CleanSurface& clean = whole.Cleaned;
  const std::vector<Vector3>& points = clean.Surface.Points;
  const std::vector<Index> ofTriangle = LabelsOf(clean, labels);
  for (std::size_t t = 0; t < ofTriangle.size(); ++t)
  {
    const Triangle& c = clean.Surface.Triangles[t];
    areas[static_cast<std::size_t>(ofTriangle[t])].Input +=
      AreaVector(points[c[0]], points[c[1]], points[c[2]]).norm();
  }
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    areas[i].Output = areas[i].Input;
    for (const auto& part : parts)
    {
      const LabelArea& one = part->Result.Report.Labels[i];
      areas[i].Output += one.Output - one.Input;
    }
  }
  return areas;
}
}
