// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WeldRun.h"

#include "Base/StageClock.h"
#include "Mesh/Checksum.h"
#include "Mesh/Cleaning.h"
#include "OptionConflict.h"
#include "Options/NumberRange.h"
#include "Repair/Diagnostics/Diagnostics.h"
#include "Run/Input/Weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace bonedecimate
{
namespace
{
class WeldRun
{
public:
  WeldRun(const Surface& input, const Options& options, const RunInputs& inputs)
    : Input(input)
    , Requested(options)
    , Inputs(inputs)
    , Error(options.MaxError(options.VoxelSize))
  {
  }

  Result Run(const Monitor& monitor, const WholeRun& run)
  {
    const StageClock clock;
    Options rest = this->Requested;
    rest.WeldDistance = 0.0;
    RunInputs inputs = this->Inputs;
    const bool isRead = this->WeldInput();
    if (this->Error > 0.0 && this->Figures.Movement > 0.5 * this->Error)
    {
      return RejectedResult(this->Requested,
        "WeldDistance moves points by up to " + NumberText(this->Figures.Movement) +
          " mm, more than half of the largest error of " + NumberText(this->Error) +
          " mm, which includes it");
    }
    const bool isChanged = this->Figures.Points > 0;
    if (isChanged)
    {
      this->Reduce(rest, inputs);
    }
    const double seconds = clock.Seconds();
    Result result = run(isChanged ? this->Welded : this->Input, rest, monitor, inputs);
    result.Report.Requested = this->Requested;
    result.Report.Weld = this->Figures;
    result.Report.Weld.HasRun = isRead;
    if (isChanged)
    {
      this->Widen(rest, result);
    }
    result.Report.Seconds.Prepare += seconds;
    result.Report.Seconds.Total += seconds;
    return result;
  }

private:
  /// False if the input will be rejected.
  bool WeldInput()
  {
    CleaningStatistics found;
    const std::vector<double>* tolerances = this->Inputs.Tolerances;
    if (CheckSurface(this->Input, this->Requested.NumberOfThreads, found) != InputStatus::Good ||
      (tolerances != nullptr && tolerances->size() != this->Input.Points.size()))
    {
      return false;
    }
    // A tolerance has to be left for what follows.
    std::vector<char> stays;
    for (std::size_t i = 0; tolerances != nullptr && i < tolerances->size(); ++i)
    {
      const double tolerance = (*tolerances)[i];
      stays.push_back(tolerance >= 0.0 && tolerance < 2.0 * this->Requested.WeldDistance ? 1 : 0);
    }
    WeldedPoints welded = Weld(this->Input, this->Requested.WeldDistance, stays);
    this->Figures.Points = welded.Moved;
    this->Figures.Movement = welded.Movement;
    if (welded.Moved > 0)
    {
      this->Welded.Points = std::move(welded.Points);
      this->Welded.Triangles = this->Input.Triangles;
    }
    return true;
  }

  /// Rounded down, so that the movement can be added again.
  double Less(double length) const { return std::nextafter(length - this->Figures.Movement, 0.0); }

  void Reduce(Options& rest, RunInputs& inputs)
  {
    if (this->Error > 0.0)
    {
      rest.MaximumError = this->Less(this->Error);
      rest.ErrorPreset = ErrorPreset::NoPreset;
    }
    rest.DiagnoseInput = false;
    inputs.Regions = nullptr; // which are those of the input
    if (inputs.Tolerances != nullptr)
    {
      this->Tolerances = *inputs.Tolerances;
      for (std::size_t i = 0; i < this->Tolerances.size(); ++i)
      {
        double& tolerance = this->Tolerances[i];
        tolerance = tolerance > 0.0 ? std::max(0.0, this->Less(tolerance)) : tolerance;
      }
      inputs.Tolerances = &this->Tolerances;
    }
  }

  double More(double length) const { return length + this->Figures.Movement; }

  void WidenDistance(ProvedDistance& distance) const
  {
    distance.Lower = std::max(0.0, distance.Lower - this->Figures.Movement);
    distance.Upper = this->More(distance.Upper);
  }

  /// Makes what is bounded, and what names the input, refer to the input.
  void Widen(const Options& rest, Result& result) const
  {
    Report& report = result.Report;
    const auto restored = [&](double length) {
      return length == rest.MaximumError ? this->Error : length > 0.0 ? this->More(length) : length;
    };
    report.Size.MaxError = restored(report.Size.MaxError);
    report.Size.ErrorBound = restored(report.Size.ErrorBound);
    report.InputChecksum = Checksum(this->Input, this->Requested.NumberOfThreads);
    if (this->Requested.DiagnoseInput)
    {
      report.Diagnostics = Diagnose(this->Input, this->Requested.NumberOfThreads);
    }
    ErrorProof& proof = report.Proof;
    proof.Tolerance = restored(proof.Tolerance);
    for (ProvedDistance* distance : { &proof.InputToOutput, &proof.OutputToInput,
           &proof.BoundaryInputToOutput, &proof.BoundaryOutputToInput })
    {
      this->WidenDistance(*distance);
    }
    for (LeftOut& leftOut : report.LeftOut)
    {
      leftOut.Distance = this->More(leftOut.Distance); // not a number stays one
    }
    for (std::vector<double>* bounds : { &result.ErrorBound, &result.InputErrorBound })
    {
      for (double& bound : *bounds)
      {
        bound = this->More(bound);
      }
    }
  }

  const Surface& Input;
  const Options& Requested;
  const RunInputs& Inputs;
  double Error; // mm; 0: none, or that of a preset without a voxel size
  WeldFigures Figures;
  Surface Welded;
  std::vector<double> Tolerances;
};

/// At least the length, with three digits.
std::string RoundedUp(double length)
{
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 2.0);
  std::array<char, 32> text = {};
  std::snprintf(text.data(), text.size(), "%.3g", std::ceil(length / unit) * unit);
  return text.data();
}

/// Why the run cannot weld; empty: it can.
std::string ConflictOf(const Options& options, const RunInputs& inputs)
{
  if (!options.MergePoints)
  {
    return "WeldDistance needs MergePoints, which joins what was welded";
  }
  if (options.ErrorPreset != ErrorPreset::NoPreset && options.VoxelSize == 0.0)
  {
    return "WeldDistance with ErrorPreset needs VoxelSize, because the surface does not show it";
  }
  return FindConflict(options, inputs);
}
}

Result WeldThenRun(const Surface& input, const Options& options, const Monitor& monitor,
  const RunInputs& inputs, const WholeRun& run)
{
  if (!(options.WeldDistance > 0.0))
  {
    return run(input, options, monitor, inputs);
  }
  const std::string conflict = ConflictOf(options, inputs);
  return conflict.empty() ? WeldRun(input, options, inputs).Run(monitor, run)
                          : RejectedResult(options, conflict);
}

std::vector<std::string> WeldSentences(const WeldFigures& figures)
{
  if (!figures.HasRun)
  {
    return {};
  }
  return { figures.Points == 0
      ? std::string(
          "no point was welded: no edges of open boundaries are near enough to each other")
      : std::to_string(figures.Points) + (figures.Points == 1 ? " point was" : " points were") +
        " welded onto others and moved by up to " + RoundedUp(figures.Movement) +
        " mm, which the largest error includes" };
}
}
