// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SurfaceFormat.h"
#include "LevelsCommand.h"

#include "Arguments/CommonOptions.h"
#include "Arguments/FileGrid.h"
#include "Arguments/HelpFormatter.h"
#include "CommandLine.h"
#include "Files/SameFile.h"
#include "Settings/Settings.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace bonedecimate
{
namespace
{
void AddRunOptions(CLI::App& app, LevelsArguments& arguments)
{
  AddFile(app, "--log", "LOG", arguments.Log,
    "Take the levels from this log, recorded on the same INPUT, instead of a run.");
  AddFile(app, "--record", "LOG", arguments.Record, "Write the log of the run.");
  AddNumber(app,
    { "--coarsest", "N", TriangleRange,
      "Triangles of the coarsest level; default a tenth of the input's or the least number of "
      "--triangles, whichever is less, or with --max-error as few as that allows." },
    [&arguments](double value) { arguments.Coarsest = static_cast<int>(value); });
  AddMode(app, arguments.Mode, ModeNamesWhere([](const ModeInfo&) { return true; }, "|"),
    "Of the run, default " + arguments.Mode + ".");
  AddNumber(app,
    { "--max-error", "MM", PositiveLengthRange,
      "Largest distance that the run may cause; every level keeps it." },
    [&arguments](double value) { arguments.MaximumError = value; });
  AddAllowLargeError(app, arguments.AllowLargeError);
  AddVoxelArguments(app, arguments.Voxels);
  AddInputArguments(app, arguments.Input);
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
  AddGlbCompression(app, arguments.CompressesGlb, [](const std::string&) {});
  AddFile(app, "--on", "SURFACE", arguments.On,
    "Put the levels on this surface, which has the triangles of INPUT and other points, such as a "
    "bone registered to it.");
  AddFile(app, "--page", "HTML", arguments.Page,
    "Write a self-contained HTML page for people, with a slider through the levels that are "
    "listed.");
  AddThreads(app, arguments.Threads);
  AddUnit(app, arguments.Unit);
  AddQuiet(app, arguments.Quiet);
  AddSettings(app, arguments.Settings);
}

void CheckPage(const LevelsArguments& arguments)
{
  if (arguments.Page.empty())
  {
    return;
  }
  if (!arguments.On.empty())
  {
    throw Failure(
      ExitCode::Usage, "--page compares levels with INPUT, and --on puts them on another surface");
  }
  RequireExtension("--page", arguments.Page, { "html", "htm" });
}

/// What the formats of input and output do not have.
void CheckFormats(const LevelsArguments& arguments)
{
  const SurfaceFormat* const input = FindFormat(arguments.Files[0]);
  const SurfaceFormat* const output = FindFormat(arguments.Output);
  const std::string lack = LackText(arguments.Output);
  if (!lack.empty())
  {
    throw Failure(ExitCode::Usage, lack);
  }
  if (!arguments.Unit.IsMillimeter() && input != nullptr && input->NamesUnit &&
    !input->UnitMayDiffer)
  {
    throw Failure(ExitCode::Usage,
      "--unit is for files that do not name their unit; '" + arguments.Files[0] + "' does");
  }
  if (output != nullptr && output->HasGrid && arguments.Input.HasTolerances())
  {
    throw Failure(ExitCode::Usage,
      "--region and --tolerance-array do not go together with levels in " +
        std::string(output->Extension) + ", whose grid rounds points again");
  }
}

void CheckTogether(const CLI::App& app, const LevelsArguments& arguments)
{
  for (const char* flag :
    { "--record", "--coarsest", "--mode", "--max-error", "--no-errors", "--smooth",
      "--feature-angle", "--keep-voxels", "--region", "--tolerance-array", "--reference" })
  {
    if (!arguments.Log.empty() && app.count(flag) > 0)
    {
      throw Failure(
        ExitCode::Usage, std::string(flag) + " is for a run, and --log takes its place");
    }
  }
  CheckLabel(arguments.Voxels.Map, "--label-map");
  CheckSpacing(arguments.Voxels.Map);
  CheckSeries(arguments.Voxels.Map);
  if (arguments.Input.HasTolerances() && !arguments.Unit.IsMillimeter())
  {
    throw Failure(ExitCode::Usage,
      "--region and --tolerance-array need --unit mm, because another unit rounds levels again");
  }
  const bool wantsLevels = !arguments.Triangles.empty() || !arguments.Errors.empty();
  if (wantsLevels == arguments.Output.empty())
  {
    throw Failure(ExitCode::Usage,
      wantsLevels ? "--output is needed for the levels" : "--output needs --triangles or --errors");
  }
  if (wantsLevels && FindFormat(arguments.Output) == nullptr)
  {
    throw Failure(ExitCode::Usage,
      "--output '" + arguments.Output + "' needs one of the extensions " + SurfaceExtensions());
  }
  CheckFormats(arguments);
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
  KeepSurfaces(arguments, {});
  CheckPage(arguments);
}
}

void AddLevelsCommand(CLI::App& program)
{
  const auto arguments = std::make_shared<LevelsArguments>();
  CLI::App& command = AddCommand(program, "levels", { "INPUT [OPTIONS]" },
    "Levels of detail: one run, recorded, and any stage of it at once, by a number of triangles or "
    "by a measured distance.");
  AddSurfaces(command, arguments->Files, "A surface");
  AddRunOptions(command, *arguments);
  AddLevelOptions(command, *arguments);
  command.final_callback(
    [&command, arguments]
    {
      RequireFiles(command, arguments->Files, 1, "one INPUT");
      CheckTogether(command, *arguments);
      RunLevels(*arguments);
    });
}

void KeepSurfaces(const LevelsArguments& arguments, const std::string& level)
{
  RequireDistinct({ level, arguments.Page, arguments.Record },
    { arguments.Files[0], arguments.On, arguments.Log, arguments.Voxels.Map.Path,
      arguments.Input.Reference });
}
}
