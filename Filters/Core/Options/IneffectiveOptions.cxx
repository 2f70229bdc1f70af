// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IneffectiveOptions.h"

#include "OptionTable.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
bool HasNormalTolerance(const Options& options)
{
  return FindMode(options.Mode).HasNormalTolerance();
}

bool HasError(const Options& options)
{
  return options.MaximumError > 0.0 || options.ErrorPreset != ErrorPreset::NoPreset;
}

bool IsLimited(const Options& options)
{
  return HasError(options) || !options.ToleranceArrayName.empty();
}

/// Whether there is an error to prove; smoothing alone has one, too.
bool HasProvableError(const Options& options)
{
  return options.ProvesError() &&
    (IsLimited(options) || (options.Smooths() && options.KeepsAllTriangles()));
}

bool IsProved(const Options& options)
{
  return options.ProveResult && HasProvableError(options);
}

/// Whether the run ends at a number of triangles; the default reduction is ignored if there is an error.
bool HasNumber(const Options& options)
{
  return options.TargetNumberOfTriangles > 0 || options.EndsAtReduction(HasError(options));
}

bool MeasuresResult(const Options& options)
{
  return options.MeasureDistances || FindMode(options.Mode).RecordsDistances;
}

bool HasEdgeLength(const Options& options)
{
  return options.EffectiveEdgeLength() > 0.0;
}

struct Need
{
  const char* Option;
  bool (*IsMet)(const Options&);
  std::string What;
};

std::vector<Need> MakeNeeds()
{
  const std::string provingMode =
    "another Mode than " + ModeNamesWhere([](const ModeInfo& mode) { return !mode.ProvesError(); });
  const std::string toleranceMode =
    "Mode " + ModeNamesWhere([](const ModeInfo& mode) { return mode.HasNormalTolerance(); });
  const std::string shapeMode =
    "Mode " + ModeNamesWhere([](const ModeInfo& mode) { return mode.LimitsShapes(); });
  const std::string edgeLength = "EdgeLength and " + shapeMode;
  const std::string proof =
    "ProveResult with MaximumError, ErrorPreset or ToleranceArrayName, and " + provingMode;
  return {
    { "AllowLargeError", IsLimited, "MaximumError, ErrorPreset or ToleranceArrayName" },
    { "IntersectionGuard", [](const Options& o) { return o.BoundsError(); },
      "MaximumError or ErrorPreset, and " + provingMode },
    { "ProveResult", HasProvableError,
      "MaximumError, ErrorPreset or ToleranceArrayName, and " + provingMode },
    { "RefinementEffort",
      [](const Options& o) { return IsLimited(o) && FindMode(o.Mode).Refine.ProvedRounds > 0; },
      "MaximumError, ErrorPreset or ToleranceArrayName, and Mode " +
        ModeNamesWhere([](const ModeInfo& mode) { return mode.Refine.ProvedRounds > 0; }) },
    { "MinimumAngle", [](const Options& o) { return o.MinimumAngle == o.EffectiveMinimumAngle(); },
      shapeMode },
    { "MinimumAngle", [](const Options& o) { return !o.KeepsAllTriangles(); },
      "TargetReduction above 0" },
    { "EdgeLength", [](const Options& o) { return o.EdgeLength == o.EffectiveEdgeLength(); },
      shapeMode },
    { "EdgeLength", [](const Options& o) { return !o.KeepsAllTriangles(); },
      "TargetReduction above 0" },
    { "ChordalError", HasEdgeLength, edgeLength },
    { "EdgeLengthArrayName", HasEdgeLength, edgeLength },
    { "VoxelSize", [](const Options& o) { return o.ErrorPreset != ErrorPreset::NoPreset; },
      "ErrorPreset" },
    { "AutomaticSmoothing", [](const Options& o) { return o.Smoothing == 0.0; }, "Smoothing 0" },
    { "FeatureAngle", [](const Options& o) { return o.Smooths(); },
      "Smoothing or AutomaticSmoothing" },
    { "NormalTolerance", HasNormalTolerance, toleranceMode },
    { "NormalTolerance",
      [](const Options& o)
      { return !HasNormalTolerance(o) || !o.AutomaticNormalTolerance || !HasNumber(o); },
      "AutomaticNormalTolerance off" },
    { "AutomaticNormalTolerance",
      [](const Options& o) { return HasNormalTolerance(o) && HasNumber(o); },
      toleranceMode + " and TargetNumberOfTriangles or TargetReduction" },
    { "DistanceArrayName", MeasuresResult, "MeasureDistances" },
    { "RunningErrorArrayName", MeasuresResult, "MeasureDistances" },
    { "InputDistanceArrayName", [](const Options& o) { return o.MeasureInputDistances; },
      "MeasureInputDistances" },
    { "ErrorBoundArrayName", IsProved, proof },
    { "InputErrorBoundArrayName",
      [](const Options& o) { return IsProved(o) && o.MeasureInputDistances; },
      "MeasureInputDistances and " + proof },
  };
}
}

std::vector<std::string> IneffectiveOptions(
  const Options& options, const std::vector<std::string>& given)
{
  static const std::vector<Need> needs = MakeNeeds();
  std::vector<std::string> sentences;
  for (const Need& need : needs)
  {
    const bool isSet = std::find(given.begin(), given.end(), need.Option) != given.end();
    if (isSet && !need.IsMet(options))
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
