// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <type_traits>

namespace bonedecimate
{
namespace
{
constexpr double Largest = std::numeric_limits<double>::max();
constexpr double LargestInteger = std::numeric_limits<int>::max();

template <typename Field>
using FieldType = std::decay_t<decltype(std::declval<Options>().*std::declval<Field>())>;

/// The kind of value in which a field travels: choices as int, the others as themselves.
template <typename Type>
using TravelType = std::conditional_t<std::is_enum_v<Type>, int, Type>;

/// "any number up to" reads better than 1.79769e+308.
std::string RangeText(const OptionInfo& info)
{
  char text[80];
  if (info.Maximum == Largest)
  {
    std::snprintf(text, sizeof(text), "%g or more", info.Minimum);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.10g to %.10g", info.Minimum, info.Maximum);
  }
  return text;
}

std::string NumberText(double value)
{
  char text[40];
  for (int digits = 6; digits <= 17; ++digits)
  {
    std::snprintf(text, sizeof(text), "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value)
    {
      break;
    }
  }
  return text;
}

std::string Lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

std::string WithoutDashes(std::string text)
{
  text.erase(std::remove(text.begin(), text.end(), '-'), text.end());
  return text;
}

/// Reads "on", "off", "true", ... ; -1 if it is none of them.
int ReadSwitch(const std::string& text)
{
  const std::string word = Lower(text);
  if (word == "on" || word == "true" || word == "yes" || word == "1")
  {
    return 1;
  }
  return word == "off" || word == "false" || word == "no" || word == "0" ? 0 : -1;
}

int ReadChoice(const OptionInfo& info, const std::string& text)
{
  for (std::size_t i = 0; i < info.Choices.size(); ++i)
  {
    if (Lower(info.Choices[i]) == Lower(WithoutDashes(text)))
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

std::string Join(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string SetNumberFromText(
  Options& options, const OptionInfo& info, const std::string& text, bool integer)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool isNumber = !text.empty() && *end == '\0' && std::isfinite(value);
  const bool fits = isNumber && (!integer || value == std::floor(value));
  if (!fits || value < info.Minimum || value > info.Maximum)
  {
    return info.Name + " takes " + (integer ? "a whole number, " : "a number, ") + RangeText(info) +
      (info.Unit.empty() ? "" : " " + info.Unit) + ", not '" + text + "'";
  }
  if (integer)
  {
    SetOption(options, info, static_cast<int>(value));
  }
  else
  {
    SetOption(options, info, value);
  }
  return {};
}

std::string KindText(const OptionInfo& info)
{
  if (!info.Choices.empty())
  {
    return Join(info.Choices);
  }
  const OptionValue value = GetOption(Options{}, info);
  if (std::holds_alternative<bool>(value))
  {
    return "on, off";
  }
  return std::holds_alternative<std::string>(value) ? "text" : RangeText(info);
}

/// What to reach, and how.
std::vector<OptionInfo> GoalRows()
{
  return {
    { "Mode", &Options::Mode, 0, 3, "", "mode", { "Thesis", "Fast", "Balanced", "Accurate" },
      "How the result is found. Balanced, the default, collapses like Fast, takes the last "
      "triangles by the distance to samples of the original, then moves points and flips edges so "
      "that they come to lie nearer. Accurate does more of each. Fast only collapses edges, "
      "ordered "
      "by what that does to the normals, and very nearly keeps the volume. Thesis takes the vertex "
      "of lowest normal field deviation, then its edge of lowest cost, and goes on while there are "
      "more triangles than asked for or no new point is farther away than MaximumError; the others "
      "end at the first stop reached." },
    { "TargetNumberOfTriangles", &Options::TargetNumberOfTriangles, 0, LargestInteger, "triangles",
      "target-faces", {}, "Number of triangles to reach; 0 is off." },
    { "TargetReduction", &Options::TargetReduction, 0, 1, "", "target-reduction", {},
      "Fraction of the triangles to remove; 1 is off, 0 removes none. The default steps back when "
      "a number of triangles "
      "or a largest error is asked for, or every point has a tolerance." },
    { "MaximumError", &Options::MaximumError, 0, Largest, "mm", "max-error", {},
      "Largest distance in both directions, proved: no point of the input is farther from the "
      "result, and no point of the result farther from the input, open borders curve to curve; 0 "
      "is "
      "off. In Thesis mode it is the distance of a new point at which the collapse stops: exactly "
      "one "
      "point may lie beyond it, and places between points may, too." },
    { "KeepClearance", &Options::KeepClearance, 0, 1, "", "keep-clearance", {},
      "With MaximumError: no more pairs of triangles intersect than before, and what faces each "
      "other across a "
      "gap, two fragments or the walls of a fracture, keeps half of the distance that it had. Not "
      "in Thesis mode." },
    { "NormalTolerance", &Options::NormalTolerance, 0, 1, "", "normal-tolerance", {},
      "The tolerance w of the normal field deviation. Smaller values make flat areas dearer; at 1 "
      "a flat edge costs "
      "nothing whatever its length." },
    { "AutomaticNormalTolerance", &Options::AutomaticNormalTolerance, 0, 1, "",
      "auto-normal-tolerance", {},
      "In Thesis mode with a number of triangles or a reduction to reach: NormalTolerance is "
      "chosen by the share of the triangles that stays, 0.95 for half of them or more, 0 for a "
      "tenth or less. The report says which it was." },
  };
}

/// What is done with the input, and what is measured.
std::vector<OptionInfo> RunRows()
{
  return {
    { "MergePoints", &Options::MergePoints, 0, 1, "", "merge-points", {},
      "Merge points with exactly equal coordinates first. Off, triangles that do not share points "
      "are fragments of their "
      "own." },
    { "MeasureDistances", &Options::MeasureDistances, 0, 1, "", "measure", {},
      "Measure the distances between input and result in both directions." },
    { "MeasureInputDistances", &Options::MeasureInputDistances, 0, 1, "", "", {},
      "Return the input with the distance of each of its points to the result." },
    { "NumberOfThreads", &Options::NumberOfThreads, 0, 1024, "threads", "threads", {},
      "Threads to use; 0 is one per processor. The result does not depend on it." },
    { "OutputPointsPrecision", &Options::OutputPointsPrecision, 0, 2, "", "precision",
      { "Single", "Double", "Default" },
      "Precision of the output points; Default is that of the input." },
    { "PassArrays", &Options::PassArrays, 0, 1, "", "pass-arrays", {},
      "Give the result the input's arrays of points and cells: floating values as they are at the "
      "place on the input that "
      "is nearest to the new point, everything else from the nearest point, or the cell nearest to "
      "the middle of the "
      "triangle." },
    { "MakeMaps", &Options::MakeMaps, 0, 1, "", "maps", {},
      "Give the result the arrays OriginalPointIds and OriginalCellIds, nearest point and cell of "
      "the input, and the input "
      "on output port 1 ResultPointIds, the point of the result that each input point became part "
      "of." },
    { "RecomputeNormals", &Options::RecomputeNormals, 0, 1, "", "recompute-normals", {},
      "Give the result point normals of its own triangles, not those of the input." },
  };
}

/// Names of arrays.
std::vector<OptionInfo> ArrayRows()
{
  return {
    { "DistanceArrayName", &Options::DistanceArrayName, 0, 0, "", "", {},
      "Name of the array of the distance of each output point to the input surface, in mm." },
    { "RunningErrorArrayName", &Options::RunningErrorArrayName, 0, 0, "", "", {},
      "Name of the array of the largest distance recorded along the collapses into each output "
      "point, in mm." },
    { "PointCountArrayName", &Options::PointCountArrayName, 0, 0, "", "", {},
      "Name of the array of how many input points each output point stands for." },
    { "InputDistanceArrayName", &Options::InputDistanceArrayName, 0, 0, "", "", {},
      "Name of the array of the distance of each input point to the result, in mm." },
  };
}

/// What is proved.
std::vector<OptionInfo> ProofRows()
{
  return {
    { "ToleranceArrayName", &Options::ToleranceArrayName, 0, 0, "", "tolerance-array", {},
      "Name of a point array of the input, of any type of number, with how far the surface may "
      "move "
      "at each point, in mm: 0 freezes the point with all triangles at it, negative is no limit of "
      "its own, in between it is a largest error there, linear on each triangle and proved like "
      "MaximumError, which caps it. Empty is none. Thesis takes only 0 and negative ones." },
    { "ProveResult", &Options::ProveResult, 0, 1, "", "prove", {},
      "With MaximumError in every mode but Thesis: certify the result as it is written, both "
      "directions and open borders, and report the proved bounds." },
    { "ErrorBoundArrayName", &Options::ErrorBoundArrayName, 0, 0, "", "", {},
      "Name of the array of the proved bound at each output point, in mm: no point of the "
      "triangles around it is farther from the input. Only with ProveResult." },
    { "InputErrorBoundArrayName", &Options::InputErrorBoundArrayName, 0, 0, "", "", {},
      "Name of the array of the proved bound at each input point, in mm: no point of the triangles "
      "around it is farther from the result. Only with ProveResult and MeasureInputDistances." },
    { "ErrorPreset", &Options::ErrorPreset, 0, 3, "", "preset",
      { "None", "QuarterVoxel", "HalfVoxel", "OneVoxel" },
      "A largest error as a share of the least side of the scan's voxels (VoxelSize); MaximumError "
      "counts, too, if it is smaller. A quarter of a voxel is below what the scan shows, a half "
      "is about how far a surface may be off by the scan alone, one is for overviews." },
    { "VoxelSize", &Options::VoxelSize, 0, Largest, "mm", "voxel-size", {},
      "Least side of the scan's voxels, for ErrorPreset; 0: estimated from the surface, which "
      "must be as marching cubes leaves it, and reported as an estimate." },
  };
}
}

const std::vector<OptionInfo>& OptionTable()
{
  static const std::vector<OptionInfo> table = []
  {
    std::vector<OptionInfo> rows;
    for (const std::vector<OptionInfo>& group : { GoalRows(), RunRows(), ArrayRows(), ProofRows() })
    {
      rows.insert(rows.end(), group.begin(), group.end());
    }
    return rows;
  }();
  return table;
}

const OptionInfo* FindOption(const std::string& name)
{
  for (const OptionInfo& info : OptionTable())
  {
    if (info.Name == name)
    {
      return &info;
    }
  }
  return nullptr;
}

OptionValue GetOption(const Options& options, const OptionInfo& info)
{
  return std::visit(
    [&](auto field) -> OptionValue
    {
      using Type = FieldType<decltype(field)>;
      return static_cast<TravelType<Type>>(options.*field);
    },
    info.Field);
}

void SetOption(Options& options, const OptionInfo& info, const OptionValue& value)
{
  std::visit(
    [&](auto field)
    {
      using Type = FieldType<decltype(field)>;
      auto given = std::get<TravelType<Type>>(value);
      if constexpr (std::is_same_v<Type, double>)
      {
        given =
          std::isnan(given) ? Options{}.*field : std::clamp(given, info.Minimum, info.Maximum);
      }
      else if constexpr (std::is_same_v<Type, int> || std::is_enum_v<Type>)
      {
        given = std::clamp(given, static_cast<int>(info.Minimum), static_cast<int>(info.Maximum));
      }
      options.*field = static_cast<Type>(given);
    },
    info.Field);
  options.TargetReductionIsExplicit =
    options.TargetReductionIsExplicit || info.Name == "TargetReduction";
}

std::string SetOptionFromText(Options& options, const OptionInfo& info, const std::string& text)
{
  const OptionValue current = GetOption(options, info);
  if (!info.Choices.empty())
  {
    const int choice = ReadChoice(info, text);
    if (choice < 0)
    {
      return info.Name + " takes one of " + Join(info.Choices) + ", not '" + text + "'";
    }
    SetOption(options, info, choice);
    return {};
  }
  if (std::holds_alternative<bool>(current))
  {
    const int on = ReadSwitch(text);
    if (on < 0)
    {
      return info.Name + " takes on or off, not '" + text + "'";
    }
    SetOption(options, info, on == 1);
    return {};
  }
  if (std::holds_alternative<std::string>(current))
  {
    SetOption(options, info, text);
    return {};
  }
  return SetNumberFromText(options, info, text, std::holds_alternative<int>(current));
}

std::string OptionText(const Options& options, const OptionInfo& info)
{
  const OptionValue value = GetOption(options, info);
  if (!info.Choices.empty())
  {
    return info.Choices[static_cast<std::size_t>(std::get<int>(value))];
  }
  if (const bool* on = std::get_if<bool>(&value))
  {
    return *on ? "on" : "off";
  }
  if (const int* number = std::get_if<int>(&value))
  {
    return std::to_string(*number);
  }
  if (const double* number = std::get_if<double>(&value))
  {
    return NumberText(*number);
  }
  return std::get<std::string>(value);
}

std::string OptionTableMarkdown()
{
  std::string text =
    "| option | flag | values | default | unit | meaning |\n|---|---|---|---|---|---|\n";
  for (const OptionInfo& info : OptionTable())
  {
    text += "| `" + info.Name + "` | " + (info.Flag.empty() ? "" : "`--" + info.Flag + "`") +
      " | " + KindText(info) + " | " + OptionText(Options{}, info) + " | " + info.Unit + " | " +
      info.Sentence + " |\n";
  }
  return text;
}
}
