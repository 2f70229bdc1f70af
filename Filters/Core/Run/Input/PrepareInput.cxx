// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PrepareInput.h"

#include "EdgeLengths.h"
#include "LabelMapInput.h"
#include "Mesh/Checksum.h"
#include "Mesh/ManifoldPatches.h"
#include "Mesh/PatchBoundaries.h"
#include "Mesh/SpatialOrder.h"
#include "PartInput.h"
#include "Prune.h"
#include "Repair/Diagnostics/Diagnostics.h"
#include "Tolerances.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace bonedecimate
{
namespace
{
CleanSurface CleanAndPrune(const RunTask& task, Report& report)
{
  const Options& options = task.Effective;
  CleanSurface cleaned = Clean(task.Input, options.MergePoints, options.NumberOfThreads);
  report.Status = cleaned.Status;
  report.Cleaning = cleaned.Statistics;
  if (options.DiagnoseInput)
  {
    report.Diagnostics = Diagnose(task.Input, options.NumberOfThreads);
  }
  if (report.Status == InputStatus::Good)
  {
    report.Pruned = Prune(task.Input, options, cleaned);
    report.Status = report.Pruned.TookAll ? InputStatus::EverythingPruned : InputStatus::Good;
  }
  return cleaned;
}

/// What the reference leaves of the largest error caps the tolerances.
ReferenceInput ReadReference(
  const RunTask& task, const PreparedInput& prepared, const Monitor& monitor, Report& report)
{
  ReferenceInput reference = CompareWithReference(
    *task.Inputs.Reference, task.Input, prepared.Cleaned, task.Effective, monitor);
  report.Status = reference.Status;
  report.Reference = reference.Figures;
  const std::vector<double>* requested = prepared.Tolerances.Requested();
  for (std::size_t i = 0; requested != nullptr && i < reference.Left.size(); ++i)
  {
    const double tolerance = (*requested)[i];
    double& left = reference.Left[i];
    left = tolerance >= 0.0 ? std::min(left, tolerance) : left;
  }
  return reference;
}

/// Checks tolerances and largest error, and reads the reference.
void PrepareErrors(RunTask& task, const Monitor& monitor, PreparedInput& prepared, Report& report)
{
  const std::vector<double>* tolerances = task.Inputs.Tolerances;
  report.HasTolerances = tolerances != nullptr;
  report.Status = CheckErrors(task.Input, prepared.Cleaned, tolerances, task.Rounding,
    task.Effective, report.Cleaning, report.Size);
  if (report.Status == InputStatus::Good && tolerances != nullptr)
  {
    prepared.Tolerances.OfPoints = LimitedTolerances(*tolerances, report.Size.Diagonal);
  }
  if (report.Status == InputStatus::Good && task.Inputs.Reference != nullptr)
  {
    prepared.Tolerances.Reference = ReadReference(task, prepared, monitor, report);
  }
}

/// Input points at which the surface is not manifold, ascending.
std::vector<Index> NonManifoldInputPoints(const Rings& rings, const CleanSurface& cleaned)
{
  std::vector<Index> points = NonManifoldPoints(rings);
  std::transform(points.begin(), points.end(), points.begin(),
    [&](Index point) { return cleaned.InputPoint[point]; });
  std::sort(points.begin(), points.end());
  return points;
}

/// The points that no feature curve passes: inner vertices of a curve can be removed.
std::vector<Index> WithoutCurves(
  const std::vector<Index>& points, const HalfEdgeMesh& mesh, const CleanSurface& cleaned)
{
  std::vector<Index> onCurves;
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.NextDuplicate(v) != v && mesh.OriginalVertex(v) == v && IsInsidePatchBoundary(mesh, v))
    {
      onCurves.push_back(cleaned.InputPoint[v]);
    }
  }
  std::sort(onCurves.begin(), onCurves.end());
  std::vector<Index> left;
  std::set_difference(
    points.begin(), points.end(), onCurves.begin(), onCurves.end(), std::back_inserter(left));
  return left;
}

void CountNonManifold(const std::vector<Index>& points, CleaningStatistics& found)
{
  found.NonManifoldPoints = static_cast<std::int64_t>(points.size());
  found.FirstNonManifoldPoint = points.empty() ? -1 : points.front();
}

/// In short steps, each left out after an abort.
HalfEdgeMesh BuildMesh(const RunTask& task, CleanSurface& cleaned, RunProgress& progress,
  const Monitor& monitor, Report& report)
{
  const int threads = task.Effective.NumberOfThreads;
  if (progress.ShouldContinue())
  {
    SortAlongCurve(cleaned, threads);
  }
  monitor(0.25);
  EdgeMatching edges(cleaned.Surface.Triangles, cleaned.Surface.Points.size(), threads);
  Rings rings = edges.FindRings();
  std::vector<Index> stay = NonManifoldInputPoints(rings, cleaned);
  const std::vector<Index> labels = PatchLabels(cleaned, task.Inputs.Labels, task.Inputs.LabelMap);
  if (!labels.empty())
  {
    edges.CutBetween(labels);
    rings = edges.FindRings();
  }
  const bool isSplit = progress.ShouldContinue() && SplitIntoManifoldPatches(cleaned, edges, rings);
  if (isSplit)
  {
    SortAlongCurve(cleaned, threads);
    edges.Match(cleaned.Surface.Points.size());
    rings = edges.FindRings();
  }
  HalfEdgeMesh mesh(cleaned.Surface, edges, std::move(rings), threads, cleaned.ManifoldPatches);
  if (isSplit && CollapsesFeatureCurves(task.Inputs))
  {
    stay = WithoutCurves(stay, mesh, cleaned);
  }
  CountNonManifold(stay, report.Cleaning);
  monitor(0.5);
  return mesh;
}
}

bool PreparedInput::IsLimitedEverywhere() const
{
  const std::vector<double>& tolerances = this->VertexTolerances;
  return !tolerances.empty() &&
    std::none_of(
      tolerances.begin(), tolerances.end(), [](double tolerance) { return tolerance < 0.0; });
}

//------------------------------------------------------------------------------
PointRounding RoundingOf(const Options& options, bool inputIsSingle)
{
  PointRounding rounding;
  rounding.ToSingle = options.WritesSingle(inputIsSingle);
  rounding.GridStep = options.OutputPointsGrid;
  return rounding;
}

//------------------------------------------------------------------------------
bool CollapsesFeatureCurves(const RunInputs& inputs)
{
  return inputs.Log == nullptr && (inputs.Labels != nullptr || HasSeveralPairs(inputs.LabelMap));
}

//------------------------------------------------------------------------------
PreparedInput PrepareInput(
  RunTask& task, double checkedAt, double builtAt, RunProgress& progress, Report& report)
{
  PreparedInput prepared;
  prepared.Cleaned = CleanAndPrune(task, report);
  progress.Stage(0.0, checkedAt)(1.0);
  if (report.Status == InputStatus::Good)
  {
    report.Status = CheckLabelMap(task.Inputs.LabelMap, task.Input, task.Effective);
    task.GuardsVoxels = GuardsVoxels(task.Inputs.LabelMap, task.Effective);
  }
  if (report.Status == InputStatus::Good)
  {
    PrepareErrors(task, progress.Stage(checkedAt, checkedAt), prepared, report);
  }
  if (report.Status == InputStatus::Good)
  {
    report.Status =
      CheckEdgeLengths(task.Inputs.EdgeLengths, task.Input.Points.size(), report.Cleaning);
  }
  if (report.Status == InputStatus::Good)
  {
    report.InputChecksum = Checksum(task.Input, task.Effective.NumberOfThreads);
    prepared.Mesh =
      BuildMesh(task, prepared.Cleaned, progress, progress.Stage(checkedAt, builtAt), report);
    if (ContinuesEarlierRun(task.Inputs))
    {
      prepared.Original = MakeReferenceMesh(task.Inputs, prepared.Cleaned, task.Effective);
      report.Status = prepared.Original ? report.Status : InputStatus::BadReference;
    }
    if (const std::vector<double>* tolerances = prepared.Tolerances.Capped())
    {
      prepared.VertexTolerances = TolerancesOf(prepared.Cleaned, *tolerances);
    }
    if (progress.ShouldContinue())
    {
      prepared.Sizes =
        MakeSizingField(prepared.Cleaned, *prepared.Mesh, task.Inputs.EdgeLengths, task.Effective);
    }
  }
  return prepared;
}
}
