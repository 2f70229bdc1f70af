// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Decimate.h"

#include "Base/RunProgress.h"
#include "Base/StageClock.h"
#include "Decimate/Cost/AutomaticTolerance.h"
#include "Decimate/Stages/DistinctPositions.h"
#include "Decimate/Stages/StageList.h"
#include "InputOperation.h"
#include "Mesh/Checksum.h"
#include "OptionConflict.h"
#include "Options/OptionTable.h"
#include "Partition/Regions/RegionRun.h"
#include "Run/Input/EdgeLengths.h"
#include "Run/Input/LabelMapInput.h"
#include "Run/Input/PartInput.h"
#include "Run/Input/PrepareInput.h"
#include "Run/Input/VoxelSize.h"
#include "Run/Output/Evaluation.h"
#include "Run/Output/Extract.h"
#include "Run/Output/FinishLog.h"
#include "Run/Output/ListLeftOut.h"
#include "Run/Output/PartComparison.h"
#include "Run/Output/ResultProof.h"
#include "SettingsOfEditor.h"
#include "SmoothInput.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Fractions of the progress at which steps end. Steps that cannot be interrupted are short.
constexpr double CheckedAt = 0.01;
constexpr double BuiltAt = 0.02;
constexpr double ExtractionFraction = 0.005;

bool EndsWithProof(const RunTask& task)
{
  return !ContinuesEarlierRun(task.Inputs) &&
    WantsProof(task.Effective, task.Inputs.Tolerances != nullptr);
}

/// Smoothing alone is proved, too: its distance becomes the largest error and leaves nothing for
/// edits.
void BoundSmoothingAlone(RunTask& task)
{
  task.Effective.MaximumError = task.Smoothing.Radius;
  task.Smoothing.SmallBelow = 0.0;
}

RunTask TaskOf(
  const Surface& input, const Options& options, const RunInputs& inputs, Report& report)
{
  RunTask task = { input, inputs, options };
  if (inputs.LabelMap != nullptr && inputs.LabelMap->Grid.Dimensions[0] > 0 &&
    options.VoxelSize == 0.0)
  {
    task.Effective.VoxelSize = inputs.LabelMap->Grid.Spacing.minCoeff();
  }
  report.Voxel =
    ApplyPreset(inputs.Reference != nullptr ? *inputs.Reference : input, task.Effective);
  task.Rounding = RoundingOf(options, inputs.InputIsSingle);
  task.Smoothing = PlanSmoothing(input, task.Effective, inputs.LabelMap);
  if (options.KeepsAllTriangles() && options.ProvesError() && task.Effective.MaximumError == 0.0)
  {
    BoundSmoothingAlone(task);
  }
  return task;
}

/// @param prepared Its mesh is moved into the editor; the rest has to outlive the editor.
std::unique_ptr<Editor> MakeEditor(
  const RunTask& task, PreparedInput& prepared, RunProgress& progress, Report& report)
{
  const Monitor building = progress.Stage(CheckedAt, BuiltAt);
  EditorSettings settings = SettingsOfEditor(task, prepared, !progress.ShouldContinue());
  if (progress.ShouldContinue())
  {
    settings.SmoothedPositions =
      SmoothInput(task, prepared, settings, PartOf(building, 0.5, 0.75), report.Smoothing);
  }
  const bool isAborted = !progress.ShouldContinue();
  auto editor = std::make_unique<Editor>(std::move(*prepared.Mesh), prepared.Cleaned,
    isAborted ? SettingsOfEditor(task, prepared, isAborted) : settings,
    PartOf(building, 0.75, 1.0));
  report.Cleaning.ConstrainedPoints = editor->Totals().ConstrainedVertices;
  return editor;
}

/// w of Decimate/Cost/NormalFieldDeviation.h. The automatic one follows from the target number of
/// faces, and needs one.
double NormalToleranceOf(const Options& options, const StopTargets& stops, Index faces)
{
  return options.AutomaticNormalTolerance && stops.Faces > 0
    ? AutomaticNormalTolerance(stops.Faces / static_cast<double>(faces))
    : options.NormalTolerance;
}

/// Runs the stages of the mode.
void RunModeStages(const RunTask& task, const PreparedInput& prepared, Editor& editor,
  const Monitor& monitor, Report& report)
{
  const Options& options = task.Effective;
  const Index faces = editor.Mesh().NumberOfFaces();
  StageInput input = { editor, FindMode(options.Mode),
    StopTargetsOf(options, faces, prepared.IsLimitedEverywhere()) };
  input.Threads = options.NumberOfThreads;
  input.RefinementEffort = options.RefinementEffort;
  input.Shape = ShapeLimitsOf(options, prepared.Sizes);
  input.Forced = &report.Edits.Forced;
  if (input.Mode.HasNormalTolerance())
  {
    input.NormalTolerance = NormalToleranceOf(options, input.Stops, faces);
    report.NormalTolerance = input.NormalTolerance;
  }
  report.Stop = RunStages(input, monitor);
}

/// Separates points of a proved result that rounding would merge.
void SeparatePoints(
  const RunTask& task, const PreparedInput& prepared, Editor& editor, Report& report)
{
  if (task.Rounding.Rounds() && task.Effective.MergePoints && editor.Bound() != nullptr &&
    report.Stop != StopReason::Aborted)
  {
    report.Status = SeparateCoincidentPoints(
      editor, task.Input, prepared.Cleaned, task.Rounding, report.Cleaning);
  }
}

/// mm; not a number if no distance was recorded or measured.
double RunningErrorOf(const Editor& editor, const std::vector<double>& errors)
{
  if (editor.Original().RecordsDistances())
  {
    return editor.Original().MaxError();
  }
  return errors.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : *std::max_element(errors.begin(), errors.end());
}

/// After an abort, computes no distances and origins.
/// @return The result's surface relative to the origin of the cleaned input, mm.
Surface ExtractResult(const RunTask& task, const PreparedInput& prepared, const Editor& editor,
  bool isAborted, const Monitor& monitor, Result& result)
{
  const int threads = task.Effective.NumberOfThreads;
  const Original& original = editor.Original();
  const bool measures = task.Effective.MeasureDistances || original.RecordsDistances();
  const ExtractOptions options = { task.Rounding, !isAborted && measures,
    !isAborted && task.Inputs.WantsOrigins, threads, task.Inputs.Labels, task.Inputs.LabelMap };
  if (options.Distances || options.Origins)
  {
    original.Tree(threads, [&] { monitor(0.0); });
  }
  Surface local;
  local.Points = Extract(task.Input, prepared.Cleaned, editor, options, monitor, result);
  local.Triangles = result.Surface.Triangles;
  monitor(1.0);
  result.Report.RunningError = RunningErrorOf(editor, result.RunningError);
  return local;
}

void ReportEdits(const RunTask& task, const PreparedInput& prepared, Editor& editor, Report& report)
{
  report.Edits.Collapses = editor.Totals().Collapses;
  report.Edits.Rejections = editor.Totals().Rejections;
  report.Edits.Draft = editor.Totals().Draft;
  if (task.Inputs.Log != nullptr)
  {
    *task.Inputs.Log =
      FinishLog(editor.TakeLog(), task, prepared.Cleaned, editor.Mesh(), report.InputChecksum);
  }
  if (task.Inputs.Labels != nullptr)
  {
    report.Labels = LabelAreas(prepared.Cleaned, editor.Mesh(), *task.Inputs.Labels);
  }
}

/// mm^3, of 27 voxels: of the grid, or of twice the bound where none is known. 0 unless a whole
/// surface was smoothed.
double MinPart(const RunTask& task, const SmoothingFigures& smoothing)
{
  if (!smoothing.HasRun() || task.Inputs.Part != nullptr)
  {
    return 0.0;
  }
  const LabelMapSource* map = task.Inputs.LabelMap;
  const LabelMapSource* source =
    map != nullptr && map->Grid.Dimensions[0] > 0 ? map : task.Smoothing.Source();
  const double side = 2.0 * smoothing.Bound;
  return 27.0 * (source != nullptr ? source->Grid.Spacing.prod() : side * side * side);
}

/// Runs the stages, and what needs their mesh. False if the result cannot be written in the
/// precision of its points.
bool Simplify(const RunTask& task, PreparedInput& prepared, RunProgress& progress, Result& result)
{
  Report& report = result.Report;
  const double extractedAt = MeasuredFrom(task.Effective, EndsWithProof(task));
  const double collapsedAt = extractedAt - ExtractionFraction;
  const StageClock building;
  const std::unique_ptr<Editor> editor = MakeEditor(task, prepared, progress, report);
  progress.Stage(CheckedAt, BuiltAt)(1.0);
  report.Seconds.Prepare += building.Seconds();

  const StageClock collapsing;
  report.Stop = StopReason::Aborted;
  if (progress.ShouldContinue())
  {
    RunModeStages(task, prepared, *editor, progress.Stage(BuiltAt, collapsedAt), report);
    SeparatePoints(task, prepared, *editor, report);
  }
  if (report.Status != InputStatus::Good)
  {
    return false;
  }
  ReportEdits(task, prepared, *editor, report);
  const Surface local = ExtractResult(task, prepared, *editor, !progress.ShouldContinue(),
    progress.Stage(collapsedAt, extractedAt), result);
  report.Seconds.Collapse = collapsing.Seconds();
  report.Seconds.Decimate = report.Seconds.Prepare + report.Seconds.Collapse;

  const KeptSurface* reference = prepared.Tolerances.ReferenceSurface();
  const EvaluatedRun run = { task.Input, prepared.Cleaned, *editor, local,
    reference != nullptr ? &reference->Surface : nullptr, EndsWithProof(task), task.Inputs,
    prepared.Sizes, MinPart(task, report.Smoothing) };
  Evaluate(run, task.Effective, progress, result);
  return true;
}

/// Code of its own voxelizes input and result, whether the voxels were guarded or not.
void CheckVoxels(const RunTask& task, RunProgress& progress, Result& result)
{
  const LabelMapSource* map = task.Inputs.LabelMap;
  const bool isWhole = task.Inputs.Part == nullptr;
  if (isWhole && map != nullptr && map->Grid.Dimensions[0] > 0 && progress.ShouldContinue())
  {
    const double at = MeasuredTo(EndsWithProof(task));
    result.Report.Voxels = CompareWithInput(task.Input, result.Surface, result.BoundaryLabels, *map,
      task.Effective.NumberOfThreads, progress.Stage(at, at));
    result.Report.Voxels.WereGuarded = task.GuardsVoxels;
  }
}

/// Called when the memory of the stages has been released, because the proof needs the two surfaces
/// alone.
void Prove(const RunTask& task, PreparedInput& prepared, RunProgress& progress, Result& result)
{
  if (EndsWithProof(task) && progress.ShouldContinue())
  {
    prepared.Cleaned.Surface = {};
    ProveResult(task.Input, prepared.Cleaned, task.Effective, progress.Stage(MeasuredTo(true), 1.0),
      result, prepared.Tolerances.Requested(), prepared.Tolerances.ReferenceSurface());
  }
}

/// The run of all triangles, whatever may change.
Result DecimateWhole(
  const Surface& input, const Options& options, const Monitor& monitor, const RunInputs& inputs)
{
  const StageClock clock;
  RunProgress progress(monitor);
  Result result;
  Report& report = result.Report;
  report.Requested = options;
  RunTask task = TaskOf(input, options, inputs, report);
  PreparedInput prepared = PrepareInput(task, CheckedAt, BuiltAt, progress, report);
  report.Seconds.Prepare = clock.Seconds();
  if (report.Status == InputStatus::Good && Simplify(task, prepared, progress, result))
  {
    CheckVoxels(task, progress, result);
    Prove(task, prepared, progress, result);
    ListLeftOut(input, prepared.Cleaned, prepared.Tolerances.ReferenceSurface(), inputs, result);
    if (!progress.ShouldContinue())
    {
      MarkAborted(EndsWithProof(task), report);
    }
  }
  report.Seconds.Total = clock.Seconds();
  return result;
}

/// Applies the operations that the options request, runs the rest, and restores what refers to the
/// input.
Result DecimateAfterOperations(
  const Surface& input, const Options& options, const Monitor& monitor, const RunInputs& inputs)
{
  constexpr double appliedAt = 0.1;
  const StageClock clock;
  RunProgress progress(monitor);
  RunRequest request = { &input, options, inputs };
  const std::vector<std::unique_ptr<InputOperation>> operations = InputOperations(options);
  for (const std::unique_ptr<InputOperation>& operation : operations)
  {
    std::string conflict = FindConflict(request.Options, request.Inputs);
    if (conflict.empty())
    {
      conflict = operation->Apply(request, progress.Stage(0.0, appliedAt));
    }
    if (!conflict.empty())
    {
      return RejectedResult(options, conflict);
    }
  }
  progress.Stage(0.0, appliedAt)(1.0);
  const double seconds = clock.Seconds();
  Result result = DecimateRegions(
    *request.Input, request.Options, progress.Stage(appliedAt, 1.0), request.Inputs, DecimateWhole);
  for (auto operation = operations.rbegin(); operation != operations.rend(); ++operation)
  {
    (*operation)->Restore(result);
  }
  result.Report.Seconds.Prepare += seconds;
  result.Report.Seconds.Decimate += seconds;
  result.Report.Seconds.Total += seconds;
  return result;
}
}

Result Decimate(
  const Surface& input, const Options& options, const Monitor& monitor, const RunInputs& inputs)
{
  Result result;
  result.Report.Status = InputStatus::InvalidOption;
  if (CheckOptions(options).empty())
  {
    result = InputOperations(options).empty()
      ? DecimateRegions(input, options, monitor, inputs, DecimateWhole)
      : DecimateAfterOperations(input, options, monitor, inputs);
    result.Report.OutputChecksum = TriangleChecksum(result.Surface, options.NumberOfThreads);
  }
  result.Report.Requested = options;
  return result;
}

//------------------------------------------------------------------------------
SmoothedInput SmoothOnly(
  const Surface& input, const Options& options, const Monitor& monitor, const RunInputs& inputs)
{
  RunProgress progress(monitor);
  SmoothedInput result{ input.Points, {} };
  Report& report = result.Report;
  RunTask task = TaskOf(input, options, inputs, report);
  const PreparedInput prepared = PrepareInput(task, CheckedAt, BuiltAt, progress, report);
  if (report.Status != InputStatus::Good || !progress.ShouldContinue())
  {
    return result;
  }
  const std::vector<Vector3> smoothed = SmoothInput(task, prepared,
    SettingsOfEditor(task, prepared, false), progress.Stage(BuiltAt, 1.0), report.Smoothing);
  const CleanSurface& clean = prepared.Cleaned;
  if (!smoothed.empty())
  {
    report.Parts = PartComparer(clean, inputs)
                     .Compare(*prepared.Mesh, { smoothed, clean.Surface.Triangles },
                       MinPart(task, report.Smoothing));
  }
  for (std::size_t i = 0; i < result.Points.size() && !smoothed.empty(); ++i)
  {
    const Index point = clean.PointOfInput[i];
    if (point != None && smoothed[point] != clean.Surface.Points[point]) // others keep their bits
    {
      result.Points[i] = task.Rounding.Of(smoothed[point] + clean.Origin);
    }
  }
  return result;
}
}
