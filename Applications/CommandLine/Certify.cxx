// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certify.h"

#include "BoundText.h"
#include "FileChecks.h"
#include "HelpFormatter.h"
#include "Interruption.h"
#include "JsonReport.h"
#include "Numbers.h"
#include "ProgressBar.h"
#include "StagedFile.h"
#include "SurfaceFiles.h"
#include "SurfaceFormat.h"
#include "VtkMessages.h"
#include "Words.h"

#include "vtkBoneSurfaceDistance.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

namespace bonedecimate
{
namespace
{
void AddOptions(CLI::App& app, CertifyArguments& arguments)
{
  AddNumber(app,
    { "--tolerance", "MM", LengthRange, "How far any point of one surface may be from the other." },
    [&arguments](double value) { arguments.Tolerance = value; });
  app
    .add_option("--tolerance-array", arguments.ToleranceArray,
      WrappedHelp("A point array of the reference (.vtp, .vtk) with a tolerance for each point in "
                  "mm; negative: none of its own. --tolerance caps it."))
    ->type_name("NAME");
  app.add_option("--json", arguments.Json, WrappedHelp("Write everything found as JSON."))
    ->type_name("FILE");
  AddNumber(app,
    { "--gap", "RATIO", { 1e-12, 1.0, false, "" },
      "By which ratio of the upper bound the lower may be less; default 1e-6." },
    [&arguments](double value) { arguments.Gap = value; });
  AddNumber(app,
    { "--mean-precision", "RATIO", { 1e-4, 1.0, false, "" },
      "Relative precision of average and root mean square; default 0.005." },
    [&arguments](double value) { arguments.Precision = value; });
  AddThreads(app, arguments.Threads);
  AddUnit(app, arguments.Unit);
  app.add_flag("--first-proof", arguments.FirstProof,
    WrappedHelp("Stop at the tolerance: no closer bounds where it is proved."));
  app.add_flag(
    "--no-means", arguments.WithoutMeans, WrappedHelp("No average and root mean square."));
  app.add_flag("--no-borders", arguments.WithoutBorders,
    WrappedHelp("Surfaces alone, not their open borders."));
  app.add_flag("--quiet", arguments.Quiet, "Nothing on the standard output.");
}

constexpr int BoundDecimals = 9;

/// One run; the steps stand in RunCertify.
class CertifyRun
{
public:
  explicit CertifyRun(const CertifyArguments& arguments)
    : Asked(arguments)
  {
  }

  void Read()
  {
    const MillimeterSurface reference = ReadInMillimeters(this->Asked.Reference, this->Asked.Unit);
    const MillimeterSurface result = ReadInMillimeters(this->Asked.Result, this->Asked.Unit);
    for (const MillimeterSurface* loaded : { &reference, &result })
    {
      this->Warnings.insert(this->Warnings.end(), loaded->Warnings.begin(), loaded->Warnings.end());
    }
    if (!this->Asked.ToleranceArray.empty() &&
      !reference.Surface->GetPointData()->GetArray(this->Asked.ToleranceArray.c_str()))
    {
      Refuse(this->Asked.Reference, "it has no point array '" + this->Asked.ToleranceArray + "'");
    }
    this->Filter->SetInputData(0, reference.Surface);
    this->Filter->SetInputData(1, result.Surface);
  }

  void Compare()
  {
    if (this->Asked.Tolerance)
    {
      this->Filter->SetTolerance(*this->Asked.Tolerance);
    }
    this->Filter->SetToleranceArrayName(this->Asked.ToleranceArray);
    this->Filter->SetTightBounds(!this->Asked.FirstProof);
    this->Filter->SetRelativeGap(this->Asked.Gap);
    this->Filter->SetMeasureBorders(!this->Asked.WithoutBorders);
    this->Filter->SetMeasureMeans(!this->Asked.WithoutMeans);
    this->Filter->SetMeanPrecision(this->Asked.Precision);
    this->Filter->SetNumberOfThreads(this->Asked.Threads);
    vtkNew<ProgressBar> bar;
    bar->SetShown(!this->Asked.Quiet);
    this->Filter->AddObserver(vtkCommand::ProgressEvent, bar);
    TakeVtkMessages();
    this->Filter->Update();
    bar->Clear();
    StopIfInterrupted();
    const VtkMessages messages = TakeVtkMessages();
    const std::string problem = this->Filter->GetReportText("problem");
    if (!messages.Errors.empty() || !problem.empty())
    {
      throw Failure(ExitCode::InputRefused,
        "'" + BaseName(this->Asked.Reference) + "' and '" + BaseName(this->Asked.Result) +
          "' were refused: " + (messages.Errors.empty() ? problem : messages.Errors.front()));
    }
    this->Warnings.insert(this->Warnings.end(), messages.Warnings.begin(), messages.Warnings.end());
  }

  void Write()
  {
    if (!this->Asked.Json.empty())
    {
      WriteTextFile(this->Asked.Json,
        ComposeJsonCertificate(this->Filter->GetOutput(), this->Asked.Reference, this->Asked.Result,
          this->Asked.Unit.Name, this->Warnings));
    }
  }

  void Tell()
  {
    if (this->Asked.Quiet)
    {
      return;
    }
    std::cout << "distance             "
              << LowerBoundText(this->Filter->GetLowerBound(), BoundDecimals) << " to "
              << UpperBoundText(this->Filter->GetUpperBound(), BoundDecimals) << " mm, two-sided\n";
    this->TellDirection("reference_to_result", "reference -> result  ");
    this->TellDirection("result_to_reference", "result -> reference  ");
    const std::string borders = this->Filter->GetReportText("borders");
    this->TellDirection("border_reference_to_result", "border, ref. -> res. ");
    this->TellDirection("border_result_to_reference", "border, res. -> ref. ");
    if (borders == "reference_only" || borders == "result_only")
    {
      std::cout << "borders              only the "
                << (borders == "result_only" ? "result" : "reference") << " has some\n";
    }
    this->TellVerdict();
    for (const std::string& warning : this->Warnings)
    {
      std::cout << "warning: " << warning << "\n";
    }
    std::cout << "seconds              " << FixedText(this->Value("seconds"), 2) << "\n";
  }

  ExitCode Code() const
  {
    switch (this->Filter->GetVerdict())
    {
      case vtkBoneSurfaceDistance::VIOLATED:
        return ExitCode::Violated;
      case vtkBoneSurfaceDistance::UNDECIDED:
        return ExitCode::Undecided;
      default:
        return ExitCode::Done;
    }
  }

private:
  double Value(const std::string& name) const { return this->Filter->GetReportValue(name); }

  void TellDirection(const std::string& path, const std::string& words) const
  {
    const double lower = this->Value(path + ".lower");
    if (std::isnan(lower))
    {
      return;
    }
    std::cout << words << LowerBoundText(lower, BoundDecimals) << " to "
              << UpperBoundText(this->Value(path + ".upper"), BoundDecimals) << " mm";
    const auto triangle = static_cast<long long>(this->Value(path + ".triangle"));
    if (triangle >= 0)
    {
      std::cout << " at (" << FixedText(this->Value(path + ".x"), 4) << ", "
                << FixedText(this->Value(path + ".y"), 4) << ", "
                << FixedText(this->Value(path + ".z"), 4) << "), triangle " << triangle;
    }
    std::cout << "\n";
    const double mean = this->Value(path + ".mean");
    if (!std::isnan(mean))
    {
      std::cout << "                     mean " << FixedText(mean, 6) << " +- "
                << FixedText(this->Value(path + ".mean_error"), 6) << ", RMS "
                << FixedText(this->Value(path + ".rms"), 6) << " +- "
                << FixedText(this->Value(path + ".rms_error"), 6) << " mm\n";
    }
  }

  void TellVerdict() const
  {
    const std::string map =
      this->Asked.ToleranceArray.empty() ? "" : "the map '" + this->Asked.ToleranceArray + "'";
    const std::string number =
      this->Asked.Tolerance ? FixedText(*this->Asked.Tolerance, 6) + " mm" : "";
    if (this->Filter->GetVerdict() != vtkBoneSurfaceDistance::NOT_ASKED)
    {
      std::cout << "tolerance            " << this->Filter->GetVerdictAsString() << " <= " << map
                << (map.empty() || number.empty() ? "" : " and ") << number << "\n";
    }
  }

  const CertifyArguments& Asked;
  std::vector<std::string> Warnings;
  vtkNew<vtkBoneSurfaceDistance> Filter;
};

bool IsSameFile(const std::string& a, const std::string& b)
{
  std::error_code error;
  return std::filesystem::equivalent(a, b, error);
}
}

/// Options that would have no effect.
void CheckTogether(const CLI::App& app, const CertifyArguments& arguments)
{
  const bool hasTolerance = arguments.Tolerance || !arguments.ToleranceArray.empty();
  if (arguments.FirstProof && !hasTolerance)
  {
    throw Failure(
      ExitCode::Usage, "--first-proof has no effect; it needs --tolerance or --tolerance-array");
  }
  if (arguments.WithoutMeans && app.count("--mean-precision") > 0)
  {
    throw Failure(ExitCode::Usage, "--mean-precision has no effect with --no-means");
  }
}

std::optional<CertifyArguments> ParseCertifyArguments(int argc, char* argv[])
{
  CertifyArguments arguments;
  std::vector<std::string> files;
  CLI::App app("Proves how far two surfaces are from each other: bounds of the largest distance in "
               "both directions, of surfaces and of open borders, and where it is.",
    "bonedecimate certify");
  app.formatter(std::make_shared<HelpFormatter>("REFERENCE RESULT [OPTIONS]"));
  app.footer(ExitCodesText());
  app
    .add_option(
      "FILES", files, WrappedHelp("Two surfaces (obj, stl, ply, vtp, vtk), in mm or --unit."))
    ->type_name("")
    ->allow_extra_args();
  AddOptions(app, arguments);
  if (!ParseWords(app, WordsOf(argc, argv, 2)))
  {
    return {};
  }
  if (files.size() != 2)
  {
    throw Failure(ExitCode::Usage,
      "certify takes REFERENCE RESULT; there are " + std::to_string(files.size()) + " files");
  }
  CheckTogether(app, arguments);
  arguments.Reference = files[0];
  arguments.Result = files[1];
  if (IsSameFile(arguments.Json, files[0]) || IsSameFile(arguments.Json, files[1]))
  {
    throw Failure(
      ExitCode::Usage, "'" + arguments.Json + "' is one of the surfaces; it is not overwritten");
  }
  return arguments;
}

ExitCode RunCertify(const CertifyArguments& arguments)
{
  CertifyRun run(arguments);
  run.Read();
  StopIfInterrupted();
  run.Compare();
  run.Write();
  run.Tell();
  return run.Code();
}
}
