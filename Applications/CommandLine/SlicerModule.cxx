// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlicerModule.h"

#include "Arguments.h"
#include "Numbers.h"
#include "ReportFields.h"
#include "RunOne.h"
#include "SlicerXml.h"
#include "StagedFile.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
namespace
{
using Words = std::vector<std::string>;

/// What a panel says in Slicer's words.
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
  std::replace(word.begin(), word.end(), '_', '-');
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
  inside.Tolerance = arguments.Options.MaximumError;
  inside.Text = "--roi " + text;
  arguments.Regions.push_back(inside);
  arguments.Regions.push_back({ Region::Rest, {}, 0.0, "rest" });
}

void AddPlaces(const SlicerWords& asked, Arguments& arguments)
{
  if (asked.Region.empty() && asked.Kept.empty())
  {
    return;
  }
  if (!arguments.Options.PromisesError())
  {
    throw Failure(
      ExitCode::Usage, "--roi and --keep need --max-error, in another mode than Thesis");
  }
  const double radius = ReadNumber("--keep-radius", asked.KeptRadius, LengthRange);
  for (const std::string& place : asked.Kept)
  {
    Region ball;
    ball.Shape = Region::Sphere;
    ball.Numbers = Numbers("--keep", place, 3);
    ball.Numbers.push_back(radius);
    ball.Text = "--keep " + place;
    arguments.Regions.push_back(ball);
  }
  if (!asked.Region.empty())
  {
    AddRegion(asked.Region, arguments);
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

void Run(const Words& words)
{
  const SlicerWords asked = Sorted(words);
  Words own = { "bonedecimate" };
  own.insert(own.end(), asked.Rest.begin(), asked.Rest.end());
  std::vector<char*> pointers;
  std::transform(own.begin(), own.end(), std::back_inserter(pointers),
    [](std::string& word) { return word.data(); });
  pointers.push_back(nullptr);
  std::optional<Arguments> arguments =
    ParseArguments(static_cast<int>(own.size()), pointers.data());
  if (!arguments)
  {
    return;
  }
  arguments->HasTags = true;
  CheckArguments(*arguments);
  if (IsBatch(*arguments))
  {
    throw Failure(ExitCode::Usage, "--returnparameterfile is for one bone");
  }
  AddPlaces(asked, *arguments);
  std::cout << "<filter-start>\n<filter-name>vtkBoneDecimate</filter-name>\n"
               "<filter-comment> \"Bone decimation\" </filter-comment>\n</filter-start>\n"
            << std::flush;
  WriteResults(RunOne(*arguments), asked.ResultFile);
  std::cout << "<filter-end>\n<filter-name>vtkBoneDecimate</filter-name>\n</filter-end>\n"
            << std::flush;
}
}

bool IsSlicerCall(int argc, char* argv[])
{
  return std::any_of(argv + 1, argv + std::max(argc, 1),
    [](const char* word)
    {
      const std::string text = word;
      return text == "--xml" || text == "--returnparameterfile";
    });
}

//------------------------------------------------------------------------------
ExitCode RunSlicerCall(int argc, char* argv[])
{
  const Words words(argv + 1, argv + argc);
  if (std::find(words.begin(), words.end(), "--xml") != words.end())
  {
    std::cout << SlicerXml();
    return ExitCode::Done;
  }
  Run(words);
  return ExitCode::Done;
}
}
