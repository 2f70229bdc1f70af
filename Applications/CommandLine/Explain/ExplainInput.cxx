// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Explain/ExplainInput.h"

#include "Arguments/FlagNames.h"
#include "FilePath.h"
#include "Formats/FileChecks.h"
#include "NamedArrays.h"
#include "Run/Input/PrepareInput.h"
#include "Run/Input/Tolerances.h"
#include "Segments/SegmentOutput.h"

#include "vtkPolyData.h"

#include <filesystem>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Empty if the run takes the input.
std::string ProblemOf(vtkPolyData* surface, Options options)
{
  const NamedArrays named = ReadNamedArrays(surface, options);
  if (!named.Problem.empty())
  {
    return named.Problem;
  }
  const Surface& input = named.Converted.Surface;
  const CleanSurface clean = Clean(input, options.MergePoints, options.NumberOfThreads);
  Report report;
  report.Requested = options;
  report.Status = clean.Status;
  report.Cleaning = clean.Statistics;
  if (report.Status == InputStatus::Good)
  {
    const RunInputs inputs = named.Inputs();
    report.HasTolerances = inputs.Tolerances != nullptr;
    report.Status = CheckErrors(input, clean, inputs.Tolerances,
      RoundingOf(options, inputs.InputIsSingle), options, report.Cleaning, report.Size);
  }
  return InputMessage(report);
}
}

void RequireUsable(vtkPolyData* surface, const Options& options, const Arguments& arguments)
{
  const std::string problem = ProblemOf(surface, options);
  if (!problem.empty())
  {
    const std::string& path = arguments.Inputs[0];
    Reject(path, WithUnitHint(WithFlags(problem), path, arguments.Unit));
  }
}

std::vector<std::string> MissingFolders(const Arguments& arguments)
{
  std::vector<std::string> sentences;
  if (IsBatch(arguments) || WritesSegments(arguments))
  {
    return sentences; // the run makes the folder
  }
  for (const std::string& output : OutputsOf(arguments))
  {
    std::error_code error;
    const std::filesystem::path folder = FilePath(output).parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, error))
    {
      sentences.push_back(
        "could not write '" + output + "': there is no folder '" + folder.string() + "'");
    }
  }
  return sentences;
}

void ExplainUnchecked(const Arguments& arguments, bool isRead, Explanation& explanation)
{
  const Options& options = arguments.Options;
  const std::pair<bool, const char*> unchecked[] = {
    { !isRead, "the surface: its size against the largest error, its arrays and its triangles" },
    { isRead && !arguments.Reference.empty(), "the distance of the input to --reference" },
    { !arguments.LabelMap.Path.empty() || options.KeepVoxels == KeepVoxels::On,
      "whether the label map or the voxel grid is that of the surface" },
    { options.TunnelSize > 0.0, "whether the tunnels can be closed" },
    { options.Prunes(), "whether anything is left after pruning" },
    { true, "whether the files can be written, and the memory" },
  };
  for (const auto& [isLeft, what] : unchecked)
  {
    if (isLeft)
    {
      explanation.Add("not checked", what);
    }
  }
}
}
