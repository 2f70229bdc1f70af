// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Explain/ExplainBound.h"

#include "Arguments/FilterOptions.h"
#include "Arguments/InputArguments.h"
#include "Explain/ExplainInput.h"
#include "Figures/BoundText.h"
#include "Files/OutputRounding.h"
#include "NumberText.h"
#include "Run/Input/SmoothingPlan.h"
#include "Run/Input/VoxelSize.h"
#include "SurfaceConversion.h"

#include "vtkBoneDecimate.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <map>

namespace bonedecimate
{
namespace
{
/// "every point", "12 points"
std::string PointsText(vtkIdType count, vtkIdType all)
{
  return count == all
    ? "every point"
    : GroupedText(static_cast<double>(count)) + (count == 1 ? " point" : " points");
}

std::string ToleranceText(double tolerance, double largest)
{
  const bool isCapped = largest > 0.0 && (tolerance < 0.0 || tolerance > largest);
  return tolerance == 0.0 ? "does not change"
    : isCapped            ? LengthText(largest) + ", the largest error"
    : tolerance < 0.0     ? "no limit"
                          : LengthText(tolerance) + ", linear on each triangle";
}

/// The tolerances of points, each value once if they are few.
void ExplainTolerances(
  vtkPolyData* surface, const std::string& name, double largest, Explanation& explanation)
{
  constexpr std::size_t mostListed = 8;
  vtkDataArray* const values = surface->GetPointData()->GetArray(name.c_str());
  std::map<double, vtkIdType> counts;
  for (vtkIdType i = 0; values != nullptr && i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    ++counts[value < 0.0 ? -1.0 : value];
  }
  const vtkIdType all = surface->GetNumberOfPoints();
  if (counts.size() <= mostListed)
  {
    for (const auto& [tolerance, count] : counts)
    {
      explanation.Add("bound", PointsText(count, all) + ": " + ToleranceText(tolerance, largest));
    }
    return;
  }
  const double least = std::max(counts.begin()->first, counts.upper_bound(-1.0)->first);
  explanation.Add("bound",
    "the tolerance of each point in '" + name + "': " +
      GroupedText(static_cast<double>(counts.size())) + " values from " + LengthText(least) +
      " to " + LengthText(counts.rbegin()->first) + ", capped by the largest error; " +
      PointsText(counts.count(0.0) > 0 ? counts[0.0] : 0, all) + " with 0 do not change; " +
      PointsText(counts.count(-1.0) > 0 ? counts[-1.0] : 0, all) + " with none of their own");
}

/// Replaces the preset by the largest error.
void ExplainPreset(
  const Surface& surface, const BoundSubject& subject, Options& options, Explanation& explanation)
{
  if (options.ErrorPreset == ErrorPreset::NoPreset)
  {
    return;
  }
  const std::string preset = OptionText(options, *FindOption("ErrorPreset"));
  const double requested = options.MaximumError;
  if (options.VoxelSize == 0.0 && subject.VoxelSize == 0.0 && surface.Points.empty())
  {
    explanation.Add(
      "bound", preset + " of the smallest voxel spacing of the neural network's grid");
    return;
  }
  const bool isTyped = options.VoxelSize > 0.0;
  options.VoxelSize = isTyped ? options.VoxelSize : subject.VoxelSize;
  const VoxelFigures voxel = ApplyPreset(surface, options);
  const std::string source = isTyped           ? "of --voxel-size"
    : subject.VoxelSize > 0.0                  ? "of the volume"
    : voxel.From == VoxelFigures::Source::Grid ? "estimated from the grid planes in the surface"
                                               : "estimated from the lengths of edges";
  explanation.Add("bound",
    LengthText(options.MaximumError) + ": " + preset + " of " + LengthText(voxel.Size) +
      ", the smallest voxel spacing, " + source +
      (requested > 0.0 && requested <= options.MaximumError ? "; --max-error is smaller" : ""));
  if (subject.MayBeCoarser && !isTyped)
  {
    explanation.Add("bound", "larger if a neural network made the labels on a coarser grid");
  }
}

std::string SourceText(SmoothingFigures::Source source)
{
  using Source = SmoothingFigures::Source;
  return source == Source::Binary ? "the surface of a binary segmentation"
    : source == Source::LabelMap  ? "the surface of a label map"
    : source == Source::GrayLevel
    ? "a gray-level surface, which automatic smoothing leaves as it is"
    : "a surface without a voxel grid, which automatic smoothing leaves as it is";
}

void ExplainSmoothing(const Surface& surface, const Options& options, Explanation& explanation)
{
  if (!options.Smooths())
  {
    return;
  }
  if (surface.Points.empty())
  {
    explanation.Add("smoothing", "its bound follows from the surface, once it has been extracted");
    return;
  }
  const SmoothingPlan plan = PlanSmoothing(surface, options, nullptr);
  const std::string part = options.BoundsError() ? ", which the largest error includes" : "";
  const std::string source = options.Smoothing > 0.0 ? "--smooth" : SourceText(plan.From);
  explanation.Add("smoothing",
    plan.Radius > 0.0
      ? "no point moves by more than " + LengthText(plan.Radius) + part + ": " + source
      : "none: " + source);
}

void ExplainVoxels(const Arguments& arguments, const Options& options, Explanation& explanation)
{
  const bool hasMap = arguments.Segments.IsRequested() || !arguments.LabelMap.Path.empty();
  if (options.KeepVoxels == KeepVoxels::On)
  {
    explanation.Add("voxels", "none may change its label: --keep-voxels On");
  }
  else if (hasMap && options.KeepVoxels == KeepVoxels::Automatic)
  {
    explanation.Add("voxels",
      options.ErrorPreset == ErrorPreset::OneVoxel
        ? "may change their labels: the largest error is above half a voxel (--keep-voxels On "
          "keeps them)"
        : "none may change its label if there is no largest error or one of at most half a voxel: "
          "--keep-voxels Auto");
  }
}

void ExplainReference(const Arguments& arguments, Explanation& explanation)
{
  if (!arguments.Reference.empty())
  {
    explanation.Add("bound",
      "less the distance of the input to '" + arguments.Reference +
        "', which the run proves first, because the largest error is relative to that");
  }
}

void ExplainReserve(double requested, const Options& options, Explanation& explanation)
{
  if (options.OutputPointsGrid > 0.0)
  {
    explanation.Add("bound",
      "points are rounded to multiples of " + LengthText(options.OutputPointsGrid) +
        " for the file; the bound includes that");
  }
  if (options.MaximumError < requested)
  {
    explanation.Add("bound",
      "the run keeps " + FixedText(options.MaximumError, 9) +
        " mm, because coordinates in the unit of the file are rounded by up to " +
        FixedText(requested - options.MaximumError, 9) + " mm");
  }
}
}

Options ExplainBound(
  const Arguments& arguments, const BoundSubject& subject, Explanation& explanation)
{
  Options options = OptionsForFiles(arguments);
  const bool isRequested =
    options.MaximumError > 0.0 && options.ErrorPreset == ErrorPreset::NoPreset;
  if (isRequested)
  {
    explanation.Add("bound",
      LengthText(options.MaximumError) +
        (options.ProvesError() ? " everywhere, in both directions, proved: --max-error"
                               : ": --max-error ends the run at the first new vertex that is "
                                 "farther, and proves nothing"));
  }
  const Surface surface =
    subject.Surface != nullptr ? ToSurface(subject.Surface, 1).Surface : Surface();
  ExplainPreset(surface, subject, options, explanation);
  ExplainReference(arguments, explanation);
  ExplainVoxels(arguments, options, explanation);
  if (subject.Surface == nullptr)
  {
    ExplainSmoothing(surface, options, explanation);
    return options;
  }
  OutputRounding rounding(arguments);
  rounding.SetInput(subject.Surface, subject.InFile);
  const double requested = options.MaximumError;
  rounding.Reserve(options);
  ExplainReserve(requested, options, explanation);
  NeedPointArray(subject.Surface, options.EdgeLengthArrayName, arguments.Inputs[0]);
  vtkNew<vtkBoneDecimate> filter;
  std::vector<std::string> warnings;
  const vtkSmartPointer<vtkPolyData> input = ApplyRegions(arguments.Regions,
    options.ToleranceArrayName, arguments.Inputs[0], subject.Surface, filter, warnings);
  const std::string array =
    arguments.Regions.empty() ? options.ToleranceArrayName : filter->GetToleranceArrayName();
  if (!array.empty())
  {
    ExplainTolerances(input, array, options.MaximumError, explanation);
    options.ToleranceArrayName = array;
  }
  for (const std::string& warning : warnings)
  {
    explanation.Add("warning", warning);
  }
  if (!options.BoundsError() && array.empty() && !isRequested)
  {
    explanation.Add("bound", "none: no largest error and no tolerances");
  }
  RequireUsable(input, options, arguments);
  ExplainSmoothing(surface, options, explanation);
  return options;
}
}
