// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorCommands.h"

#include "Arguments/CommonOptions.h"
#include "Arguments/FilterOptions.h"
#include "CommandLine.h"
#include "CurvePicture.h"
#include "Figures/BoundText.h"
#include "Files/FileNames.h"
#include "Files/SameFile.h"
#include "Files/StagedFile.h"
#include "Formats/FileChecks.h"
#include "NumberText.h"
#include "Report/CountText.h"
#include "Report/JsonReport.h"
#include "Run/Report/Report.h"
#include "Runs/FilterRun.h"
#include "Settings/Settings.h"
#include "Terminal/Interruption.h"

#include "vtkBoneErrorSearch.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr int ErrorDecimals = 6;

void AddOptions(CLI::App& app, ErrorArguments& arguments, bool isCurve)
{
  if (isCurve)
  {
    AddNumberList(app,
      { "--errors", "MM,...", PositiveLengthRange, "Largest errors, for example 0.1,0.2,0.5,1." },
      [&arguments](double error) { arguments.Errors.push_back(error); })
      ->required();
    AddAllowLargeError(app, arguments.AllowLargeError);
    AddFile(app, "--csv", "CSV", arguments.Csv, "Write the runs as a table.");
    AddFile(app, "--picture", "SVG", arguments.Picture, "Draw the curve into an SVG.");
  }
  else
  {
    AddNumber(app,
      { "--triangles", "N", TriangleRange,
        "The number of triangles whose smallest error is looked for." },
      [&arguments](double value) { arguments.Triangles = static_cast<int>(value); })
      ->required();
    AddNumber(app,
      { "--precision", "RATIO", { 0.001, 0.5, false, "" },
        "The search ends when the error that is found and the one that was tried in vain differ "
        "by this ratio at most; default 0.02." },
      [&arguments](double value) { arguments.Precision = value; });
  }
  AddFile(app, "--json", "JSON", arguments.Json, "Write all runs as JSON.");
  AddVoxelArguments(app, arguments.Voxels);
  AddInputArguments(app, arguments.Input);
  const auto proves = [](const ModeInfo& mode) { return mode.ProvesError(); };
  AddMode(app, arguments.Mode, ModeNamesWhere(proves, "|"), "Default " + arguments.Mode + ".");
  AddThreads(app, arguments.Threads);
  AddUnit(app, arguments.Unit);
  AddQuiet(app, arguments.Quiet);
  AddSettings(app, arguments.Settings);
}

/// One run; the steps are in the order of Run().
class ErrorRun
{
public:
  explicit ErrorRun(const ErrorArguments& arguments)
    : Requested(arguments)
  {
  }

  void Read()
  {
    const std::string& path = this->Requested.Files[0];
    const MillimeterSurface loaded = ReadInput(path, this->Requested.Unit, this->Warnings);
    this->Filter->SetInputData(ApplyInputArguments(
      this->Requested.Input, path, loaded.Surface, this->Filter, this->Warnings));
    this->Filter->SetReferenceData(ReadReference(this->Requested.Input, this->Requested.Unit));
    ApplyVoxelArguments(this->Requested.Voxels, this->Filter, this->Warnings);
  }

  void Search()
  {
    this->Filter->SetMode(ModeNumber(this->Requested.Mode));
    this->Filter->SetTargetNumberOfTriangles(this->Requested.Triangles);
    this->Filter->SetRelativePrecision(this->Requested.Precision);
    this->Filter->SetNumberOfThreads(this->Requested.Threads);
    this->Filter->SetAllowLargeError(this->Requested.AllowLargeError);
    for (const double error : this->Requested.Errors)
    {
      this->Filter->AddError(error);
    }
    const VtkMessages messages = UpdateFilter(
      this->Filter, this->Requested.Quiet ? Progress::Hidden : Progress::Bar, "searching");
    AcceptMessages(messages, this->Requested.Files[0], this->Warnings, this->Requested.Unit);
  }

  void Write()
  {
    if (!this->Requested.Json.empty())
    {
      WriteJsonFile(this->Requested.Json, this->ComposeJson());
    }
    if (!this->Requested.Csv.empty())
    {
      WriteTextFile(this->Requested.Csv, this->ComposeCsv());
    }
    if (!this->Requested.Picture.empty())
    {
      std::vector<CurvePoint> points;
      points.reserve(static_cast<std::size_t>(this->Rows()));
      for (vtkIdType row = 0; row < this->Rows(); ++row)
      {
        points.push_back({ this->Value(row, "ProvedError"), this->Value(row, "Triangles") });
      }
      WriteTextFile(
        this->Requested.Picture, ComposeCurve(BaseName(this->Requested.Files[0]), points));
    }
  }

  void Tell() const
  {
    if (this->Requested.Quiet)
    {
      return;
    }
    for (vtkIdType row = 0; row < this->Rows(); ++row)
    {
      this->TellRun(row);
    }
    if (this->Requested.Triangles > 0)
    {
      this->TellResult();
    }
    PrintWarnings(this->Warnings);
  }

  ExitCode Code() const
  {
    const bool failed =
      this->Requested.Triangles > 0 && std::isnan(this->Filter->GetSmallestError());
    return failed ? ExitCode::Violated : ExitCode::Done;
  }

private:
  vtkIdType Rows() const { return this->Filter->GetTrials()->GetNumberOfRows(); }
  bool HasVoxels() const
  {
    return this->Filter->GetTrials()->GetColumnByName("ChangedVoxels") != nullptr;
  }
  double Value(vtkIdType row, const char* column) const
  {
    return this->Filter->GetTrials()->GetValueByName(row, column).ToDouble();
  }

  void TellRun(vtkIdType row) const
  {
    const double error = this->Value(row, "MaximumError");
    std::cout << (error > 0.0 ? "at most " + FixedText(error, ErrorDecimals) + " mm"
                              : "by number alone    ")
              << "  "
              << CountText(static_cast<std::int64_t>(this->Value(row, "Triangles")), "triangle")
              << ", proved <= " << UpperBoundText(this->Value(row, "ProvedError"), ErrorDecimals)
              << " mm, " << GroupedText(this->Value(row, "Seconds"), 1) << " s";
    if (this->HasVoxels())
    {
      const auto changed = static_cast<std::int64_t>(this->Value(row, "ChangedVoxels"));
      std::cout << ", " << CountText(changed, "voxel")
                << (changed == 1 ? " has another label" : " have another label");
    }
    std::cout << "\n";
  }

  void TellResult() const
  {
    const double error = this->Filter->GetSmallestError();
    if (std::isnan(error))
    {
      std::cout
        << "no surface of so few triangles: topology, boundaries or fragments would change\n";
      return;
    }
    std::cout << "smallest error  <= " << UpperBoundText(error, ErrorDecimals)
              << " mm, proved, with "
              << GroupedText(static_cast<double>(this->Filter->GetOutput()->GetNumberOfPolys()))
              << " triangles\n";
    const double vain = this->Filter->GetErrorTriedInVain();
    if (vain > 0.0)
    {
      std::cout << "tried in vain   " << FixedText(vain, ErrorDecimals) << " mm\n";
    }
  }

  Json ComposeJson() const
  {
    Json report = Json::object();
    report["version"] = Version();
    report["input"] = BaseName(this->Requested.Files[0]);
    report["unit"] = this->Requested.Unit.Name; // of the coordinates in the file
    report["mode"] = this->Requested.Mode;
    if (this->Requested.Triangles > 0)
    {
      report["triangles"] = this->Requested.Triangles;
      report["smallest_error_mm"] = this->Filter->GetSmallestError(); // null if there is none
      report["tried_in_vain_mm"] = this->Filter->GetErrorTriedInVain();
      report["precision"] = this->Requested.Precision;
    }
    report["runs"] = Json::array();
    for (vtkIdType row = 0; row < this->Rows(); ++row)
    {
      report["runs"].push_back({ { "max_error_mm", this->Value(row, "MaximumError") },
        { "triangles", static_cast<std::int64_t>(this->Value(row, "Triangles")) },
        { "proved_mm", this->Value(row, "ProvedError") },
        { "reached", this->Value(row, "Reached") != 0.0 },
        { "seconds", this->Value(row, "Seconds") } });
      if (this->HasVoxels())
      {
        report["runs"].back()["changed_voxels"] =
          static_cast<std::int64_t>(this->Value(row, "ChangedVoxels"));
      }
    }
    report["warnings"] = this->Warnings;
    AddSettingsTo(report, this->Requested.Settings);
    return report;
  }

  std::string ComposeCsv() const
  {
    std::string text = "max_error_mm,triangles,proved_mm,seconds\n";
    for (vtkIdType row = 0; row < this->Rows(); ++row)
    {
      text += FixedText(this->Value(row, "MaximumError"), ErrorDecimals) + "," +
        FixedText(this->Value(row, "Triangles"), 0) + "," +
        UpperBoundText(this->Value(row, "ProvedError"), ErrorDecimals) + "," +
        FixedText(this->Value(row, "Seconds"), 3) + "\n";
    }
    return text;
  }

  const ErrorArguments& Requested;
  std::vector<std::string> Warnings;
  vtkNew<vtkBoneErrorSearch> Filter;
};

ExitCode Run(const ErrorArguments& arguments)
{
  ErrorRun run(arguments);
  run.Read();
  StopIfInterrupted();
  run.Search();
  run.Write();
  run.Tell();
  return run.Code();
}

void Check(const CLI::App& command, const ErrorArguments& arguments)
{
  RequireFiles(command, arguments.Files, 1, "one INPUT");
  if (!arguments.Picture.empty() && ExtensionOf(arguments.Picture) != "svg")
  {
    throw Failure(ExitCode::Usage, "--picture '" + arguments.Picture + "' needs the extension svg");
  }
  CheckLabel(arguments.Voxels.Map, "--label-map");
  CheckSpacing(arguments.Voxels.Map);
  CheckSeries(arguments.Voxels.Map);
  RequireDistinct({ arguments.Json, arguments.Csv, arguments.Picture },
    { arguments.Files[0], arguments.Voxels.Map.Path, arguments.Input.Reference });
}

void AddErrorCommand(CLI::App& command, bool isCurve, ExitCode& code)
{
  const auto arguments = std::make_shared<ErrorArguments>();
  AddSurfaces(command, arguments->Files, "A surface");
  AddOptions(command, *arguments, isCurve);
  command.final_callback(
    [&command, arguments, &code]
    {
      Check(command, *arguments);
      code = Run(*arguments);
    });
}
}

void AddToleranceCommand(CLI::App& program, ExitCode& code)
{
  CLI::App& command = AddCommand(program, "tolerance", { "INPUT --triangles N [OPTIONS]" },
    "The smallest error that can be proved for a number of triangles: both directions, every "
    "point, open boundaries too.");
  AddErrorCommand(command, false, code);
}

void AddCurveCommand(CLI::App& program, ExitCode& code)
{
  CLI::App& command = AddCommand(program, "curve", { "INPUT --errors MM,... [OPTIONS]" },
    "How few triangles can be proved for each of some largest errors: both directions, every "
    "point, open boundaries too.");
  AddErrorCommand(command, true, code);
}
}
