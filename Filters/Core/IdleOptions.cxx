// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IdleOptions.h"

#include "OptionTable.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
bool IsThesis(const Options& options)
{
  return options.Mode == Mode::Thesis;
}

bool HasError(const Options& options)
{
  return options.MaximumError > 0.0 || options.ErrorPreset != ErrorPreset::NoPreset;
}

bool IsLimited(const Options& options)
{
  return HasError(options) || !options.ToleranceArrayName.empty();
}

bool IsProved(const Options& options)
{
  return options.ProveResult && IsLimited(options) && !IsThesis(options);
}

/// Whether the run ends at a number of triangles; the default reduction is ignored if there is an error.
bool HasNumber(const Options& options)
{
  const bool reduces =
    options.TargetReductionIsExplicit ? options.TargetReduction < 1.0 : !HasError(options);
  return options.TargetNumberOfTriangles > 0 || reduces;
}

bool MeasuresResult(const Options& options)
{
  return options.MeasureDistances || IsThesis(options);
}

struct Need
{
  const char* Option;
  bool (*IsMet)(const Options&);
  const char* What;
};

const Need Needs[] = {
  { "AllowLargeError", IsLimited, "MaximumError, ErrorPreset or ToleranceArrayName" },
  { "KeepClearance", [](const Options& o) { return o.PromisesError(); },
    "MaximumError or ErrorPreset, and another Mode than Thesis" },
  { "ProveResult", [](const Options& o) { return IsLimited(o) && !IsThesis(o); },
    "MaximumError, ErrorPreset or ToleranceArrayName, and another Mode than Thesis" },
  { "VoxelSize", [](const Options& o) { return o.ErrorPreset != ErrorPreset::NoPreset; },
    "ErrorPreset" },
  { "NormalTolerance", IsThesis, "Mode Thesis" },
  { "NormalTolerance",
    [](const Options& o) { return !IsThesis(o) || !o.AutomaticNormalTolerance || !HasNumber(o); },
    "AutomaticNormalTolerance off" },
  { "AutomaticNormalTolerance", [](const Options& o) { return IsThesis(o) && HasNumber(o); },
    "Mode Thesis and TargetNumberOfTriangles or TargetReduction" },
  { "DistanceArrayName", MeasuresResult, "MeasureDistances" },
  { "RunningErrorArrayName", MeasuresResult, "MeasureDistances" },
  { "InputDistanceArrayName", [](const Options& o) { return o.MeasureInputDistances; },
    "MeasureInputDistances" },
  { "ErrorBoundArrayName", IsProved,
    "ProveResult with MaximumError, ErrorPreset or ToleranceArrayName, and another Mode than "
    "Thesis" },
  { "InputErrorBoundArrayName",
    [](const Options& o) { return IsProved(o) && o.MeasureInputDistances; },
    "MeasureInputDistances and ProveResult with MaximumError, ErrorPreset or ToleranceArrayName, "
    "and another Mode than Thesis" },
};
}

std::vector<std::string> IdleOptions(const Options& options, const std::vector<std::string>& given)
{
  std::vector<std::string> sentences;
  for (const Need& need : Needs)
  {
    const bool isGiven = std::find(given.begin(), given.end(), need.Option) != given.end();
    if (isGiven && !need.IsMet(options))
    {
      sentences.push_back(std::string(need.Option) + " has no effect; it needs " + need.What);
    }
  }
  return sentences;
}

//------------------------------------------------------------------------------
std::vector<std::string> ChangedOptions(const Options& options)
{
  std::vector<std::string> names;
  for (const OptionInfo& info : OptionTable())
  {
    if (GetOption(options, info) != GetOption(Options{}, info))
    {
      names.push_back(info.Name);
    }
  }
  return names;
}
}
