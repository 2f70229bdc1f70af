// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LevelsCommand.h"

#include "HelpFormatter.h"
#include "Numbers.h"
#include "SurfaceFormat.h"
#include "Words.h"

#include <filesystem>
#include <memory>

namespace bonedecimate
{
namespace
{
void AddRunOptions(CLI::App& app, LevelsArguments& arguments)
{
  app
    .add_option("--log", arguments.Log,
      WrappedHelp("Take the levels from this log, recorded on the same INPUT, instead of a run."))
    ->type_name("FILE");
  app.add_option("--record", arguments.Record, WrappedHelp("Write the log of the run."))
    ->type_name("FILE");
  AddNumber(app,
    { "--coarsest", "N", TriangleRange,
      "Triangles of the coarsest level; default a tenth of the input's, or with --max-error as few "
      "as that allows." },
    [&arguments](double value) { arguments.Coarsest = static_cast<int>(value); });
  app.add_option("--mode", arguments.Mode, "Of the run, default Balanced.")
    ->type_name("Thesis|Fast|Balanced|Accurate")
    ->check(CLI::IsMember({ "Thesis", "Fast", "Balanced", "Accurate" }, CLI::ignore_case)
              .description(""));
  AddNumber(app,
    { "--max-error", "MM", PositiveLengthRange,
      "Largest distance that the run may cause; every level keeps it." },
    [&arguments](double value) { arguments.MaximumError = value; });
  AddAllowLargeError(app, arguments.AllowLargeError);
  app.add_flag("--no-errors", arguments.WithoutErrors,
    WrappedHelp("Do not measure how far levels are from the input."));
}

void AddLevelOptions(CLI::App& app, LevelsArguments& arguments)
{
  AddNumberList(app,
    { "--triangles", "N,...", TriangleRange, "Levels by their numbers of triangles." },
    [&arguments](double value) { arguments.Triangles.push_back(static_cast<int>(value)); });
  AddNumberList(app,
    { "--errors", "MM,...", PositiveLengthRange, "Levels by their largest measured distances." },
    [&arguments](double error) { arguments.Errors.push_back(error); });
  app
    .add_option("--output", arguments.Output,
      WrappedHelp("Where levels go: with NAME.EXT, a level to NAME-TRIANGLES.EXT."))
    ->type_name("NAME.EXT");
  app
    .add_option("--on", arguments.On,
      WrappedHelp("Put the levels on this surface, which has the triangles of INPUT and other "
                  "points, such as a bone registered to it."))
    ->type_name("FILE");
  AddThreads(app, arguments.Threads);
  AddUnit(app, arguments.Unit);
  app.add_flag("--quiet", arguments.Quiet, "Nothing on the standard output.");
}

void CheckTogether(const CLI::App& app, const LevelsArguments& arguments)
{
  for (const char* flag : { "--record", "--coarsest", "--mode", "--max-error", "--no-errors" })
  {
    if (!arguments.Log.empty() && app.count(flag) > 0)
    {
      throw Failure(
        ExitCode::Usage, std::string(flag) + " is for a run, and --log takes its place");
    }
  }
  const bool wantsLevels = !arguments.Triangles.empty() || !arguments.Errors.empty();
  if (wantsLevels == arguments.Output.empty())
  {
    throw Failure(ExitCode::Usage,
      wantsLevels ? "--output is needed for the levels" : "--output needs --triangles or --errors");
  }
  if (wantsLevels && FormatOf(arguments.Output) == SurfaceFormat::Unknown)
  {
    throw Failure(ExitCode::Usage,
      "--output '" + arguments.Output + "' needs one of the extensions " + SurfaceExtensions);
  }
  if (app.count("--allow-large-error") > 0 && app.count("--max-error") == 0)
  {
    throw Failure(ExitCode::Usage, "--allow-large-error has no effect; it needs --max-error");
  }
  for (const int triangles : arguments.Triangles)
  {
    if (triangles < arguments.Coarsest)
    {
      throw Failure(ExitCode::Usage,
        "--triangles " + std::to_string(triangles) +
          " is out of reach; --coarsest ends the run at " + std::to_string(arguments.Coarsest));
    }
  }
  if (arguments.WithoutErrors && !arguments.Errors.empty())
  {
    throw Failure(ExitCode::Usage, "--errors needs the distances that --no-errors leaves out");
  }
  KeepSurfaces(arguments, arguments.Record);
}
}

std::optional<LevelsArguments> ParseLevelsArguments(int argc, char* argv[])
{
  LevelsArguments arguments;
  std::vector<std::string> files;
  CLI::App app("Levels of detail: one run, recorded, and any stage of it at once, by a number of "
               "triangles or by a measured distance.",
    "bonedecimate levels");
  app.formatter(std::make_shared<HelpFormatter>("INPUT [OPTIONS]"));
  app.footer(ExitCodesText());
  app
    .add_option(
      "FILES", files, WrappedHelp("A surface (obj, stl, ply, vtp, vtk), in mm or --unit."))
    ->type_name("")
    ->allow_extra_args();
  AddRunOptions(app, arguments);
  AddLevelOptions(app, arguments);
  if (!ParseWords(app, WordsOf(argc, argv, 2)))
  {
    return {};
  }
  if (files.size() != 1)
  {
    throw Failure(
      ExitCode::Usage, "levels takes one INPUT; there are " + std::to_string(files.size()));
  }
  arguments.Input = files[0];
  CheckTogether(app, arguments);
  return arguments;
}

void KeepSurfaces(const LevelsArguments& arguments, const std::string& output)
{
  for (const std::string* input : { &arguments.Input, &arguments.On })
  {
    std::error_code error;
    if (std::filesystem::equivalent(output, *input, error))
    {
      throw Failure(ExitCode::Usage, "'" + output + "' is a surface; it is not overwritten");
    }
  }
}
}
