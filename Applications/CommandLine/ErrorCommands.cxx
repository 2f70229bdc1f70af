// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorCommands.h"

#include "BoundText.h"
#include "CurvePicture.h"
#include "FileChecks.h"
#include "FilterOptions.h"
#include "HelpFormatter.h"
#include "Interruption.h"
#include "NumberText.h"
#include "Numbers.h"
#include "ProgressBar.h"
#include "Report.h"
#include "StagedFile.h"
#include "SurfaceFiles.h"
#include "SurfaceFormat.h"
#include "VtkMessages.h"
#include "Words.h"

#include "vtkBoneErrorSearch.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr int BoundDecimals = 6;

void AddFile(CLI::App& app, const char* flag, std::string& value, const char* help)
{
  app.add_option(flag, value, WrappedHelp(help))->type_name("FILE");
}

void AddOptions(CLI::App& app, ErrorArguments& arguments, bool isCurve)
{
  if (isCurve)
  {
    AddNumberList(app,
      { "--errors", "MM,...", PositiveLengthRange, "Largest errors, for example 0.1,0.2,0.5,1." },
      [&arguments](double error) { arguments.Errors.push_back(error); })
      ->required();
    AddAllowLargeError(app, arguments.AllowLargeError);
    AddFile(app, "--csv", arguments.Csv, "Write the runs as a table.");
    AddFile(app, "--picture", arguments.Picture, "Draw the curve into an SVG.");
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
  AddFile(app, "--json", arguments.Json, "Write all runs as JSON.");
  app.add_option("--mode", arguments.Mode, "Default Balanced.")
    ->type_name("Fast|Balanced|Accurate")
    ->check(CLI::IsMember({ "Fast", "Balanced", "Accurate" }, CLI::ignore_case).description(""));
  AddThreads(app, arguments.Threads);
  AddUnit(app, arguments.Unit);
  app.add_flag("--quiet", arguments.Quiet, "Nothing on the standard output.");
}

/// One run; the steps stand in RunErrorCommand.
class ErrorRun
{
public:
  explicit ErrorRun(const ErrorArguments& arguments)
    : Asked(arguments)
  {
  }

  void Read()
  {
    const MillimeterSurface loaded = ReadInMillimeters(this->Asked.Input, this->Asked.Unit);
    this->Warnings = loaded.Warnings;
    this->Filter->SetInputData(loaded.Surface);
  }

  void Search()
  {
    this->Filter->SetMode(ModeNumber(this->Asked.Mode));
    this->Filter->SetTargetNumberOfTriangles(this->Asked.Triangles);
    this->Filter->SetRelativePrecision(this->Asked.Precision);
    this->Filter->SetNumberOfThreads(this->Asked.Threads);
    this->Filter->SetAllowLargeError(this->Asked.AllowLargeError);
    for (const double error : this->Asked.Errors)
    {
      this->Filter->AddError(error);
    }
    vtkNew<ProgressBar> bar;
    bar->SetShown(!this->Asked.Quiet);
    this->Filter->AddObserver(vtkCommand::ProgressEvent, bar);
    TakeVtkMessages();
    this->Filter->Update();
    bar->Clear();
    StopIfInterrupted();
    const VtkMessages messages = TakeVtkMessages();
    if (!messages.Errors.empty())
    {
      Refuse(this->Asked.Input, WithUnitHint(messages.Errors.front()));
    }
    std::transform(messages.Warnings.begin(), messages.Warnings.end(),
      std::back_inserter(this->Warnings), WithUnitHint);
  }

  void Write()
  {
    if (!this->Asked.Json.empty())
    {
      WriteTextFile(this->Asked.Json, this->ComposeJson());
    }
    if (!this->Asked.Csv.empty())
    {
      WriteTextFile(this->Asked.Csv, this->ComposeCsv());
    }
    if (!this->Asked.Picture.empty())
    {
      std::vector<CurvePoint> points;
      points.reserve(static_cast<std::size_t>(this->Rows()));
      for (vtkIdType row = 0; row < this->Rows(); ++row)
      {
        points.push_back({ this->Value(row, "ProvedError"), this->Value(row, "Triangles") });
      }
      WriteTextFile(this->Asked.Picture, ComposeCurve(BaseName(this->Asked.Input), points));
    }
  }

  void Tell() const
  {
    if (this->Asked.Quiet)
    {
      return;
    }
    for (vtkIdType row = 0; row < this->Rows(); ++row)
    {
      this->TellRun(row);
    }
    if (this->Asked.Triangles > 0)
    {
      this->TellAnswer();
    }
    for (const std::string& warning : this->Warnings)
    {
      std::cout << "warning: " << warning << "\n";
    }
  }

  ExitCode Code() const
  {
    const bool failed = this->Asked.Triangles > 0 && std::isnan(this->Filter->GetSmallestError());
    return failed ? ExitCode::Violated : ExitCode::Done;
  }

private:
  vtkIdType Rows() const { return this->Filter->GetTrials()->GetNumberOfRows(); }
  double Value(vtkIdType row, const char* column) const
  {
    return this->Filter->GetTrials()->GetValueByName(row, column).ToDouble();
  }

  void TellRun(vtkIdType row) const
  {
    const double asked = this->Value(row, "MaximumError");
    std::cout << (asked > 0.0 ? "at most " + FixedText(asked, BoundDecimals) + " mm"
                              : "by number alone    ")
              << "  " << GroupedText(this->Value(row, "Triangles")) << " triangles, proved <= "
              << UpperBoundText(this->Value(row, "ProvedError"), BoundDecimals) << " mm, "
              << GroupedText(this->Value(row, "Seconds"), 1) << " s\n";
  }

  void TellAnswer() const
  {
    const double error = this->Filter->GetSmallestError();
    if (std::isnan(error))
    {
      std::cout << "no surface of so few triangles: topology, borders or fragments would change\n";
      return;
    }
    std::cout << "smallest error  <= " << UpperBoundText(error, BoundDecimals)
              << " mm, proved, with "
              << GroupedText(static_cast<double>(this->Filter->GetOutput()->GetNumberOfPolys()))
              << " triangles\n";
    const double vain = this->Filter->GetErrorTriedInVain();
    if (vain > 0.0)
    {
      std::cout << "tried in vain   " << FixedText(vain, BoundDecimals) << " mm\n";
    }
  }

  std::string ComposeJson() const
  {
    Json report = Json::object();
    report["version"] = Version();
    report["input"] = BaseName(this->Asked.Input);
    report["unit"] = this->Asked.Unit.Name; // of the coordinates in the file
    report["mode"] = this->Asked.Mode;
    if (this->Asked.Triangles > 0)
    {
      report["triangles"] = this->Asked.Triangles;
      report["smallest_error_mm"] = this->Filter->GetSmallestError(); // null if there is none
      report["tried_in_vain_mm"] = this->Filter->GetErrorTriedInVain();
      report["precision"] = this->Asked.Precision;
    }
    report["runs"] = Json::array();
    for (vtkIdType row = 0; row < this->Rows(); ++row)
    {
      report["runs"].push_back({ { "max_error_mm", this->Value(row, "MaximumError") },
        { "triangles", static_cast<std::int64_t>(this->Value(row, "Triangles")) },
        { "proved_mm", this->Value(row, "ProvedError") },
        { "reached", this->Value(row, "Reached") != 0.0 },
        { "seconds", this->Value(row, "Seconds") } });
    }
    report["warnings"] = this->Warnings;
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

  std::string ComposeCsv() const
  {
    std::string text = "max_error_mm,triangles,proved_mm,seconds\n";
    for (vtkIdType row = 0; row < this->Rows(); ++row)
    {
      text += FixedText(this->Value(row, "MaximumError"), BoundDecimals) + "," +
        FixedText(this->Value(row, "Triangles"), 0) + "," +
        UpperBoundText(this->Value(row, "ProvedError"), BoundDecimals) + "," +
        FixedText(this->Value(row, "Seconds"), 3) + "\n";
    }
    return text;
  }

  const ErrorArguments& Asked;
  std::vector<std::string> Warnings;
  vtkNew<vtkBoneErrorSearch> Filter;
};

void CheckFiles(const ErrorArguments& arguments)
{
  if (!arguments.Picture.empty() && ExtensionOf(arguments.Picture) != "svg")
  {
    throw Failure(ExitCode::Usage, "--picture '" + arguments.Picture + "' needs the extension svg");
  }
  for (const std::string* file : { &arguments.Json, &arguments.Csv, &arguments.Picture })
  {
    std::error_code error;
    if (std::filesystem::equivalent(*file, arguments.Input, error))
    {
      throw Failure(ExitCode::Usage, "'" + *file + "' is the input; it is not overwritten");
    }
  }
}
}

std::optional<ErrorArguments> ParseErrorArguments(int argc, char* argv[])
{
  ErrorArguments arguments;
  std::vector<std::string> files;
  const bool isCurve = std::string(argv[1]) == "curve";
  CLI::App app(isCurve
      ? "How few triangles can be proved for each of some largest errors: both directions, every "
        "point, open borders too."
      : "The smallest error that can be proved for a number of triangles: both directions, every "
        "point, open borders too.",
    isCurve ? "bonedecimate curve" : "bonedecimate tolerance");
  app.formatter(std::make_shared<HelpFormatter>(
    isCurve ? "INPUT --errors MM,... [OPTIONS]" : "INPUT --triangles N [OPTIONS]"));
  app.footer(ExitCodesText());
  app
    .add_option(
      "FILES", files, WrappedHelp("A surface (obj, stl, ply, vtp, vtk), in mm or --unit."))
    ->type_name("")
    ->allow_extra_args();
  AddOptions(app, arguments, isCurve);
  if (!ParseWords(app, WordsOf(argc, argv, 2)))
  {
    return {};
  }
  if (files.size() != 1)
  {
    throw Failure(ExitCode::Usage,
      app.get_name().substr(13) + " takes one INPUT; there are " + std::to_string(files.size()));
  }
  arguments.Input = files[0];
  CheckFiles(arguments);
  return arguments;
}

ExitCode RunErrorCommand(const ErrorArguments& arguments)
{
  ErrorRun run(arguments);
  run.Read();
  StopIfInterrupted();
  run.Search();
  run.Write();
  run.Tell();
  return run.Code();
}
}
