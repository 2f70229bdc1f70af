// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlicerModule.h"

#include "Arguments/Arguments.h"
#include "Arguments/CommonOptions.h"
#include "Arguments/HelpFormatter.h"
#include "CommandLine.h"
#include "Files/StagedFile.h"
#include "ReportFields.h"
#include "Runs/RunOne.h"
#include "SlicerXml.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace bonedecimate
{
namespace
{
using Words = std::vector<std::string>;

/// The words of a panel, sorted.
struct SlicerWords
{
  Words Rest; ///< The program's own.
  std::string ResultFile;
  std::string Region;
  Words Kept;
  std::string KeptRadius = "5"; ///< mm
};

bool IsFlag(const std::string& word)
{
  return word.compare(0, 2, "--") == 0;
}

/// Slicer's --max_error is --max-error.
std::string OwnFlag(std::string word)
{
  const auto end = std::find(word.begin(), word.end(), '=');
  std::replace(word.begin(), end, '_', '-');
  return word;
}

SlicerWords Sorted(const Words& words)
{
  SlicerWords sorted;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    std::string ignored;
    const std::string word = IsFlag(words[i]) ? OwnFlag(words[i]) : words[i];
    std::string* const value = word == "--returnparameterfile" ? &sorted.ResultFile
      : word == "--roi"                                        ? &sorted.Region
      : word == "--keep"                                       ? &sorted.Kept.emplace_back()
      : word == "--keep-radius"                                ? &sorted.KeptRadius
      : word == "--processinformationaddress"                  ? &ignored
                                                               : nullptr;
    if (value == nullptr)
    {
      sorted.Rest.push_back(word);
    }
    else if (++i < words.size())
    {
      *value = words[i];
    }
    else
    {
      throw Failure(ExitCode::Usage, words[i - 1] + " takes a value");
    }
  }
  return sorted;
}

/// mm; exactly so many.
std::vector<double> Numbers(const std::string& flag, const std::string& text, std::size_t count)
{
  std::vector<double> numbers;
  const bool areNumbers = ReadNumbers(text, numbers);
  if (!areNumbers || numbers.size() != count)
  {
    throw Failure(ExitCode::Usage,
      flag + " takes " + std::to_string(count) + " numbers with commas in between, each " +
        RangeText(CoordinateRange) + ", not '" + text + "'");
  }
  return numbers;
}

/// Inside of the region of interest the largest error alone counts.
void AddRegion(const std::string& text, Arguments& arguments)
{
  const std::vector<double> n = Numbers("--roi", text, 6);
  Region inside;
  inside.Shape = Region::Box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double half = n[axis + 3];
    if (half < 0.0)
    {
      throw Failure(ExitCode::Usage,
        "--roi takes a center and three radii, each " + RangeText(LengthRange) + ", not '" + text +
          "'");
    }
    inside.Numbers.push_back(n[axis] - half);
    inside.Numbers.push_back(n[axis] + half);
  }
  const double largest = arguments.Options.MaximumError;
  inside.Tolerance = largest > 0.0 ? largest : LengthRange.Maximum; // capped by a preset
  inside.Text = "--roi " + text;
  arguments.Regions.push_back(inside);
  arguments.Regions.push_back({ Region::Rest, {}, 0.0, "rest" });
}

void AddRegions(const SlicerWords& requested, Arguments& arguments)
{
  if (requested.Region.empty() && requested.Kept.empty())
  {
    return;
  }
  if (!arguments.Options.BoundsError())
  {
    throw Failure(ExitCode::Usage,
      "--roi and --keep need --max-error, in another mode than " +
        ModeNamesWhere([](const ModeInfo& mode) { return !mode.ProvesError(); }));
  }
  const double radius = ReadNumber("--keep-radius", requested.KeptRadius, LengthRange);
  for (const std::string& center : requested.Kept)
  {
    Region ball;
    ball.Shape = Region::Sphere;
    ball.Numbers = Numbers("--keep", center, 3);
    ball.Numbers.push_back(radius);
    ball.Text = "--keep " + center;
    arguments.Regions.push_back(ball);
  }
  if (!requested.Region.empty())
  {
    AddRegion(requested.Region, arguments);
  }
}

void WriteResults(vtkPolyData* result, const std::string& path)
{
  const ReportFields report(result);
  std::string text;
  for (const SlicerResult& one : SlicerResults())
  {
    const std::string value = report.Text(one.Report);
    if (!value.empty())
    {
      text += std::string(one.Name) + " = " + value + "\n";
    }
  }
  if (!path.empty())
  {
    WriteTextFile(path, text);
  }
}

void Decimate(const SlicerWords& requested, Arguments& arguments)
{
  TakeFiles(arguments);
  arguments.HasTags = true;
  CheckArguments(arguments);
  if (IsBatch(arguments))
  {
    throw Failure(ExitCode::Usage, "--returnparameterfile is for one bone");
  }
  AddRegions(requested, arguments);
  std::cout << "<filter-start>\n<filter-name>vtkBoneDecimate</filter-name>\n"
               "<filter-comment> \"Bone decimation\" </filter-comment>\n</filter-start>\n"
            << std::flush;
  WriteResults(RunOne(arguments), requested.ResultFile);
  std::cout << "<filter-end>\n<filter-name>vtkBoneDecimate</filter-name>\n</filter-end>\n"
            << std::flush;
}

void Run(const Words& words)
{
  const SlicerWords requested = Sorted(words);
  CLI::App program(ProgramDescription(), "bonedecimate");
  Arguments arguments;
  CLI::App& command = AddCommand(program, DefaultCommand, {}, ProgramDescription());
  AddDecimateOptions(command, arguments);
  command.final_callback([&requested, &arguments] { Decimate(requested, arguments); });
  Words own = requested.Rest;
  own.insert(own.begin(), DefaultCommand);
  RunCommandLine(program, own);
}
}

bool IsSlicerCall(const std::vector<std::string>& words)
{
  return std::any_of(words.begin(), words.end(),
    [](const std::string& word) { return word == "--xml" || word == "--returnparameterfile"; });
}

//------------------------------------------------------------------------------
ExitCode RunSlicerCall(const std::vector<std::string>& words)
{
  if (std::find(words.begin(), words.end(), "--xml") != words.end())
  {
    std::cout << SlicerXml();
    return ExitCode::Done;
  }
  Run(words);
  return ExitCode::Done;
}
}
