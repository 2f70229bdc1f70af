// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WeldOperation.h"

#include "Mesh/Checksum.h"
#include "Mesh/Cleaning.h"
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
class WeldOperation : public InputOperation
{
public:
  std::string Apply(RunRequest& request, const Monitor&) override
  {
    const std::string conflict = ConflictOf(request.Options);
    if (!conflict.empty())
    {
      return conflict;
    }
    this->Before = request;
    this->Error = request.Options.MaxError(request.Options.VoxelSize);
    request.Options.WeldDistance = 0.0;
    this->Figures.HasRun = this->WeldInput();
    if (this->Error > 0.0 && this->Figures.Movement > 0.5 * this->Error)
    {
      return "WeldDistance moves points by up to " + NumberText(this->Figures.Movement) +
        " mm, more than half of the largest error of " + NumberText(this->Error) +
        " mm, which includes it";
    }
    if (this->Figures.Points > 0)
    {
      this->Reduce(request);
    }
    return {};
  }

  void Restore(Result& result) override
  {
    result.Report.Weld = this->Figures;
    if (this->Figures.Points > 0)
    {
      this->Widen(result);
    }
  }

private:
  /// Why the options do not allow welding; empty: they do.
  static std::string ConflictOf(const Options& options)
  {
    if (!options.MergePoints)
    {
      return "WeldDistance needs MergePoints, which joins what was welded";
    }
    if (options.ErrorPreset != ErrorPreset::NoPreset && options.VoxelSize == 0.0)
    {
      return "WeldDistance with ErrorPreset needs VoxelSize, because the surface does not show it";
    }
    return {};
  }

  /// False if the input will be rejected.
  bool WeldInput()
  {
    CleaningStatistics found;
    const std::vector<double>* tolerances = this->Before.Inputs.Tolerances;
    if (CheckSurface(*this->Before.Input, this->Before.Options.NumberOfThreads, found) !=
        InputStatus::Good ||
      (tolerances != nullptr && tolerances->size() != this->Before.Input->Points.size()))
    {
      return false;
    }
    // A tolerance has to be left for what follows.
    std::vector<char> stays;
    for (std::size_t i = 0; tolerances != nullptr && i < tolerances->size(); ++i)
    {
      const double tolerance = (*tolerances)[i];
      stays.push_back(
        tolerance >= 0.0 && tolerance < 2.0 * this->Before.Options.WeldDistance ? 1 : 0);
    }
    WeldedPoints welded = Weld(*this->Before.Input, this->Before.Options.WeldDistance, stays);
    this->Figures.Points = welded.Moved;
    this->Figures.Movement = welded.Movement;
    if (welded.Moved > 0)
    {
      this->Welded.Points = std::move(welded.Points);
      this->Welded.Triangles = this->Before.Input->Triangles;
    }
    return true;
  }

  /// Rounded down, so that the movement can be added again.
  double WithoutMovement(double length) const
  {
    return std::nextafter(length - this->Figures.Movement, 0.0);
  }

  void Reduce(RunRequest& request)
  {
    request.Input = &this->Welded;
    Options& options = request.Options;
    RunInputs& inputs = request.Inputs;
    if (this->Error > 0.0)
    {
      options.MaximumError = this->WithoutMovement(this->Error);
      options.ErrorPreset = ErrorPreset::NoPreset;
    }
    this->ReducedError = options.MaximumError;
    options.DiagnoseInput = false;
    inputs.Regions = nullptr; // which are those of the input
    if (inputs.Tolerances != nullptr)
    {
      this->Tolerances = *inputs.Tolerances;
      for (std::size_t i = 0; i < this->Tolerances.size(); ++i)
      {
        double& tolerance = this->Tolerances[i];
        tolerance = tolerance > 0.0 ? std::max(0.0, this->WithoutMovement(tolerance)) : tolerance;
      }
      inputs.Tolerances = &this->Tolerances;
    }
  }

  double WithMovement(double length) const { return length + this->Figures.Movement; }

  void WidenDistance(ProvedDistance& distance) const
  {
    distance.Lower = std::max(0.0, distance.Lower - this->Figures.Movement);
    distance.Upper = this->WithMovement(distance.Upper);
  }

  /// Makes what is bounded, and what names the input, refer to the input.
  void Widen(Result& result) const
  {
    Report& report = result.Report;
    const auto restored = [&](double length)
    {
      return length == this->ReducedError ? this->Error
        : length > 0.0                    ? this->WithMovement(length)
                                          : length;
    };
    report.Size.MaxError = restored(report.Size.MaxError);
    report.Size.ErrorBound = restored(report.Size.ErrorBound);
    report.InputChecksum = Checksum(*this->Before.Input, this->Before.Options.NumberOfThreads);
    if (this->Before.Options.DiagnoseInput)
    {
      report.Diagnostics = Diagnose(*this->Before.Input, this->Before.Options.NumberOfThreads);
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
      leftOut.Distance = this->WithMovement(leftOut.Distance); // not a number stays one
    }
    for (std::vector<double>* bounds : { &result.ErrorBound, &result.InputErrorBound })
    {
      for (double& bound : *bounds)
      {
        bound = this->WithMovement(bound);
      }
    }
  }

  RunRequest Before = {};
  double Error = 0.0;        // mm; 0: none, or that of a preset without a voxel size
  double ReducedError = 0.0; // mm, of the request
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
}

std::unique_ptr<InputOperation> MakeWeldOperation()
{
  return std::make_unique<WeldOperation>();
}

//------------------------------------------------------------------------------
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
