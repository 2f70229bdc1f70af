// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterOptions.h"

#include "OptionTable.h"
#include "SurfaceFormat.h"

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

namespace bonedecimate
{
namespace
{
using Setter = std::function<void(vtkBoneDecimate*, const OptionValue&)>;

template <typename Type, typename Argument>
Setter Calls(void (vtkBoneDecimate::*method)(Argument))
{
  return [method](vtkBoneDecimate* filter, const OptionValue& value)
  { (filter->*method)(std::get<Type>(value)); };
}

const std::map<std::string, Setter>& Setters()
{
  static const std::map<std::string, Setter> setters = {
    { "Mode", Calls<int>(&vtkBoneDecimate::SetMode) },
    { "TargetNumberOfTriangles", Calls<int>(&vtkBoneDecimate::SetTargetNumberOfTriangles) },
    { "TargetReduction", Calls<double>(&vtkBoneDecimate::SetTargetReduction) },
    { "MaximumError", Calls<double>(&vtkBoneDecimate::SetMaximumError) },
    { "AllowLargeError", Calls<bool>(&vtkBoneDecimate::SetAllowLargeError) },
    { "KeepClearance", Calls<bool>(&vtkBoneDecimate::SetKeepClearance) },
    { "NormalTolerance", Calls<double>(&vtkBoneDecimate::SetNormalTolerance) },
    { "AutomaticNormalTolerance", Calls<bool>(&vtkBoneDecimate::SetAutomaticNormalTolerance) },
    { "MergePoints", Calls<bool>(&vtkBoneDecimate::SetMergePoints) },
    { "MeasureDistances", Calls<bool>(&vtkBoneDecimate::SetMeasureDistances) },
    { "MeasureInputDistances", Calls<bool>(&vtkBoneDecimate::SetMeasureInputDistances) },
    { "NumberOfThreads", Calls<int>(&vtkBoneDecimate::SetNumberOfThreads) },
    { "OutputPointsPrecision", Calls<int>(&vtkBoneDecimate::SetOutputPointsPrecision) },
    { "PassArrays", Calls<bool>(&vtkBoneDecimate::SetPassArrays) },
    { "MakeMaps", Calls<bool>(&vtkBoneDecimate::SetMakeMaps) },
    { "RecomputeNormals", Calls<bool>(&vtkBoneDecimate::SetRecomputeNormals) },
    { "DistanceArrayName", Calls<std::string>(&vtkBoneDecimate::SetDistanceArrayName) },
    { "RunningErrorArrayName", Calls<std::string>(&vtkBoneDecimate::SetRunningErrorArrayName) },
    { "PointCountArrayName", Calls<std::string>(&vtkBoneDecimate::SetPointCountArrayName) },
    { "InputDistanceArrayName", Calls<std::string>(&vtkBoneDecimate::SetInputDistanceArrayName) },
    { "ProveResult", Calls<bool>(&vtkBoneDecimate::SetProveResult) },
    { "ErrorPreset", Calls<int>(&vtkBoneDecimate::SetErrorPreset) },
    { "VoxelSize", Calls<double>(&vtkBoneDecimate::SetVoxelSize) },
    { "ErrorBoundArrayName", Calls<std::string>(&vtkBoneDecimate::SetErrorBoundArrayName) },
    { "InputErrorBoundArrayName",
      Calls<std::string>(&vtkBoneDecimate::SetInputErrorBoundArrayName) },
    { "PruneSize", Calls<double>(&vtkBoneDecimate::SetPruneSize) },
    { "PruneArea", Calls<double>(&vtkBoneDecimate::SetPruneArea) },
    { "PruneVolume", Calls<double>(&vtkBoneDecimate::SetPruneVolume) },
    { "PruneTriangles", Calls<int>(&vtkBoneDecimate::SetPruneTriangles) },
    { "ExamineInput", Calls<bool>(&vtkBoneDecimate::SetExamineInput) },
    { "ToleranceArrayName", Calls<std::string>(&vtkBoneDecimate::SetToleranceArrayName) },
    { "LabelArrayName", Calls<std::string>(&vtkBoneDecimate::SetLabelArrayName) },
  };
  return setters;
}
}

void ApplyOptions(const Options& options, vtkBoneDecimate* filter)
{
  for (const OptionInfo& info : OptionTable())
  {
    const auto setter = Setters().find(info.Name);
    if (setter == Setters().end())
    {
      throw std::logic_error("the program has no setter for the option " + info.Name);
    }
    if (info.Name != "TargetReduction" || options.TargetReductionIsExplicit)
    {
      setter->second(filter, GetOption(options, info));
    }
  }
}

//------------------------------------------------------------------------------
int ModeNumber(const std::string& name)
{
  Options options;
  SetOptionFromText(options, *FindOption("Mode"), name);
  return static_cast<int>(options.Mode);
}

//------------------------------------------------------------------------------
Options OptionsForFiles(const Arguments& arguments)
{
  Options options = arguments.Options;
  const auto isSingle = [](const std::string& path) { return !HoldsDoubles(FormatOf(path)); };
  const bool isLimited = (!options.ToleranceArrayName.empty() || !arguments.Regions.empty()) &&
    options.Mode != Mode::Thesis;
  if ((options.PromisesError() || isLimited) &&
    (isSingle(arguments.Output) ||
      std::any_of(arguments.Also.begin(), arguments.Also.end(), isSingle)))
  {
    options.OutputPointsPrecision = PointsPrecision::Single;
  }
  return options;
}
}
