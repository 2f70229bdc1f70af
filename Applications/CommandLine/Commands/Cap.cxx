// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cap.h"

#include "Arguments/CommonOptions.h"
#include "Arguments/HelpFormatter.h"
#include "Base/Text.h"
#include "CommandLine.h"
#include "ExitCode.h"
#include "Files/FileNames.h"
#include "Files/SameFile.h"
#include "Files/StagedFile.h"
#include "Files/SurfaceFiles.h"
#include "Formats/SurfaceFormat.h"
#include "Report/JsonReport.h"
#include "Runs/FilterRun.h"
#include "Terminal/Interruption.h"

#include "vtkBoneCap.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>
#include <string>

namespace bonedecimate
{
namespace
{
nlohmann::ordered_json Compose(
  vtkBoneCap* filter, const CapArguments& arguments, const std::vector<std::string>& warnings)
{
  return { { "input", BaseName(arguments.Files[0]) }, { "output", BaseName(arguments.Files[1]) },
    { "unit", arguments.Unit.Name }, { "loops", arguments.Loops },
    { "plane_tolerance_mm", filter->GetPlaneTolerance() }, { "caps", filter->GetNumberOfCaps() },
    { "cap_triangles", filter->GetNumberOfCapTriangles() },
    { "cap_area_mm2", filter->GetCapArea() }, { "closed_loops", filter->GetNumberOfClosedLoops() },
    { "open_loops", filter->GetNumberOfOpenLoops() }, { "warnings", warnings } };
}

/// Boundaries that another choice of --loops takes.
std::vector<std::string> LoopWarnings(vtkBoneCap* filter)
{
  const auto open = static_cast<long long>(filter->GetNumberOfOpenLoops());
  if (open == 0 || filter->GetLoops() == vtkBoneCap::AllLoops)
  {
    return {};
  }
  return { std::to_string(open) +
    (open == 1 ? " boundary is at no plane where the surface ends and was"
               : " boundaries are at no plane where the surface ends and were") +
    " left open; --loops all closes others, too" };
}

void Tell(
  vtkBoneCap* filter, const CapArguments& arguments, const std::vector<std::string>& warnings)
{
  std::printf("caps      %lld, of %lld triangles and %.6g mm2; they are outside of every error "
              "bound and certificate\n",
    static_cast<long long>(filter->GetNumberOfCaps()),
    static_cast<long long>(filter->GetNumberOfCapTriangles()), filter->GetCapArea());
  std::printf("loops     %lld closed, %lld left open\n",
    static_cast<long long>(filter->GetNumberOfClosedLoops()),
    static_cast<long long>(filter->GetNumberOfOpenLoops()));
  std::printf("written   %s\n", arguments.Files[1].c_str());
  std::fflush(stdout);
  PrintWarnings(warnings);
}

/// @throws Failure(ExitCode::Usage)
const SurfaceFormat& FormatOf(const std::string& output)
{
  const SurfaceFormat* format = FindFormat(output);
  if (format == nullptr)
  {
    throw Failure(
      ExitCode::Usage, "'" + output + "' has none of the extensions " + SurfaceExtensions());
  }
  if (!LackText(output).empty())
  {
    throw Failure(ExitCode::Usage, LackText(output));
  }
  if (format->HasGrid)
  {
    throw Failure(ExitCode::Usage,
      "cap does not write '" + output +
        "': the format rounds points to a grid. Cap the surface before it is decimated to such a "
        "file");
  }
  return *format;
}

void Run(const CapArguments& arguments)
{
  const SurfaceFormat& format = FormatOf(arguments.Files[1]);
  StagedFile file(arguments.Files[1]);
  std::vector<std::string> warnings;
  const MillimeterSurface loaded = ReadInput(arguments.Files[0], arguments.Unit, warnings);
  StopIfInterrupted();
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(loaded.Surface);
  filter->SetLoops(arguments.Loops == "all" ? vtkBoneCap::AllLoops : vtkBoneCap::PlanarLoops);
  filter->SetPlaneTolerance(arguments.Tolerance.value_or(filter->GetPlaneTolerance()));
  AcceptMessages(
    UpdateFilter(filter, Progress::Hidden), arguments.Files[0], warnings, arguments.Unit);
  const std::vector<std::string> ofLoops = LoopWarnings(filter);
  warnings.insert(warnings.end(), ofLoops.begin(), ofLoops.end());
  const LengthUnit unit = UnitOfFile(arguments.Files[1], arguments.Unit);
  if (!format.HoldsDoubles && !loaded.IsSingle())
  {
    warnings.emplace_back("points are rounded to single precision by '" + arguments.Files[1] + "'");
  }
  WriteSurface(FromMillimeters(filter->GetOutput(), unit, loaded.IsSingle(), loaded.InFile),
    file.GetTemporary(), file.GetTarget());
  file.Flush();
  if (!arguments.Json.empty())
  {
    WriteJsonFile(arguments.Json, Compose(filter, arguments, warnings));
  }
  file.Commit();
  if (!arguments.Quiet)
  {
    Tell(filter, arguments, warnings);
  }
}
}

void AddCapCommand(CLI::App& program)
{
  const auto arguments = std::make_shared<CapArguments>();
  CLI::App& command = AddCommand(program, "cap", { "INPUT OUTPUT [OPTIONS]" },
    "Closes open boundaries of a surface by triangles between their points, for volume meshers. "
    "Caps are bone where the scan shows "
    "none: they are outside of every error bound and certificate.");
  AddSurfaces(command, arguments->Files, "Input and output");
  command
    .add_option("--loops", arguments->Loops,
      WrappedHelp("planes: boundaries at planes where the surface ends, as at the edge of a scan. "
                  "all: all others, too. Default planes."))
    ->type_name("planes|all")
    ->check(OneOf("planes|all"));
  AddNumber(command,
    { "--plane-tolerance", "MM", LengthRange,
      "How far points of a boundary may lie from its plane, and points of the surface beyond it; "
      "default 0.01." },
    [arguments](double tolerance) { arguments->Tolerance = tolerance; });
  AddFile(command, "--json", "JSON", arguments->Json, "Write counts and area as JSON.");
  AddUnit(command, arguments->Unit);
  AddQuiet(command, arguments->Quiet);
  command.final_callback(
    [&command, arguments]
    {
      RequireFiles(command, arguments->Files, 2, "INPUT and OUTPUT");
      RequireDistinct({ arguments->Files[1], arguments->Json }, { arguments->Files[0] });
      Run(*arguments);
    });
}
}
