// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certify.h"

#include "BoundText.h"
#include "CommandLine.h"
#include "CommonOptions.h"
#include "FileNames.h"
#include "FilterRun.h"
#include "Formats/FileChecks.h"
#include "HelpFormatter.h"
#include "Interruption.h"
#include "JsonReport.h"
#include "StagedFile.h"
#include "SurfaceFiles.h"

#include "vtkBoneSurfaceDistance.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
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
      WrappedHelp("A point array of the reference with a tolerance for each point in "
                  "mm; negative: none of its own. --tolerance caps it."))
    ->type_name("NAME");
  AddFile(app, "--json", arguments.Json, "Write everything found as JSON.");
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
  app.add_flag("--no-boundaries", arguments.WithoutBoundaries,
    WrappedHelp("Surfaces alone, not their open boundaries."));
  AddQuiet(app, arguments.Quiet);
}

constexpr int BoundDecimals = 9;

/// One run; the steps are in the order of AddCertifyCommand().
class CertifyRun
{
public:
  explicit CertifyRun(const CertifyArguments& arguments)
    : Requested(arguments)
  {
  }

  void Read()
  {
    const std::vector<std::string>& files = this->Requested.Files;
    const MillimeterSurface reference = ReadInput(files[0], this->Requested.Unit, this->Warnings);
    const MillimeterSurface result = ReadInput(files[1], this->Requested.Unit, this->Warnings);
    if (!this->Requested.ToleranceArray.empty() &&
      !reference.Surface->GetPointData()->GetArray(this->Requested.ToleranceArray.c_str()))
    {
      Reject(files[0], "it has no point array '" + this->Requested.ToleranceArray + "'");
    }
    this->Filter->SetInputData(0, reference.Surface);
    this->Filter->SetInputData(1, result.Surface);
  }

  void Compare()
  {
    if (this->Requested.Tolerance)
    {
      this->Filter->SetTolerance(*this->Requested.Tolerance);
    }
    this->Filter->SetToleranceArrayName(this->Requested.ToleranceArray);
    this->Filter->SetTightBounds(!this->Requested.FirstProof);
    this->Filter->SetRelativeGap(this->Requested.Gap);
    this->Filter->SetMeasureBoundaries(!this->Requested.WithoutBoundaries);
    this->Filter->SetMeasureMeans(!this->Requested.WithoutMeans);
    this->Filter->SetMeanPrecision(this->Requested.Precision);
    this->Filter->SetNumberOfThreads(this->Requested.Threads);
    const VtkMessages messages =
      UpdateFilter(this->Filter, this->Requested.Quiet ? Progress::Hidden : Progress::Bar);
    const std::string problem = this->Filter->GetReportText("problem");
    if (!messages.Errors.empty() || !problem.empty())
    {
      throw Failure(ExitCode::InputRejected,
        "'" + BaseName(this->Requested.Files[0]) + "' and '" + BaseName(this->Requested.Files[1]) +
          "' were rejected: " + (messages.Errors.empty() ? problem : messages.Errors.front()));
    }
    AcceptMessages(messages, this->Requested.Files[1], this->Warnings);
  }

  void Write()
  {
    if (!this->Requested.Json.empty())
    {
      WriteTextFile(this->Requested.Json,
        ComposeJsonCertificate(this->Filter->GetOutput(), this->Requested.Files,
          this->Requested.Unit.Name, this->Warnings));
    }
  }

  void Tell()
  {
    if (this->Requested.Quiet)
    {
      return;
    }
    std::cout << "distance             "
              << LowerBoundText(this->Filter->GetLowerBound(), BoundDecimals) << " to "
              << UpperBoundText(this->Filter->GetUpperBound(), BoundDecimals) << " mm, two-sided\n";
    this->TellDirection("reference_to_result", "reference -> result  ");
    this->TellDirection("result_to_reference", "result -> reference  ");
    const std::string boundaries = this->Filter->GetReportText("boundaries");
    this->TellDirection("boundary_reference_to_result", "boundary ref. -> res.");
    this->TellDirection("boundary_result_to_reference", "boundary res. -> ref.");
    if (boundaries == "reference_only" || boundaries == "result_only")
    {
      std::cout << "boundaries           only the "
                << (boundaries == "result_only" ? "result" : "reference") << " has some\n";
    }
    this->TellStatus();
    PrintWarnings(this->Warnings);
    std::cout << "seconds              " << FixedText(this->Value("seconds"), 2) << "\n";
  }

  ExitCode Code() const
  {
    switch (this->Filter->GetStatus())
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

  void TellStatus() const
  {
    const std::string map = this->Requested.ToleranceArray.empty()
      ? ""
      : "the map '" + this->Requested.ToleranceArray + "'";
    const std::string number =
      this->Requested.Tolerance ? FixedText(*this->Requested.Tolerance, 6) + " mm" : "";
    if (this->Filter->GetStatus() != vtkBoneSurfaceDistance::NOT_ASKED)
    {
      std::cout << "tolerance            " << this->Filter->GetStatusAsString() << " <= " << map
                << (map.empty() || number.empty() ? "" : " and ") << number << "\n";
    }
  }

  const CertifyArguments& Requested;
  std::vector<std::string> Warnings;
  vtkNew<vtkBoneSurfaceDistance> Filter;
};

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

void Check(const CLI::App& command, const CertifyArguments& arguments)
{
  RequireFiles(command, arguments.Files, 2, "REFERENCE RESULT");
  CheckTogether(command, arguments);
  RequireNotInput(arguments.Json, arguments.Files);
}

ExitCode Run(const CertifyArguments& arguments)
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

void AddCertifyCommand(CLI::App& program, ExitCode& code)
{
  const auto arguments = std::make_shared<CertifyArguments>();
  CLI::App& command = AddCommand(program, "certify", { "REFERENCE RESULT [OPTIONS]" },
    "Proves how far two surfaces are from each other: bounds of the largest distance in both "
    "directions, of surfaces and of open boundaries, and where it is.");
  AddSurfaces(command, arguments->Files, "Two surfaces");
  AddOptions(command, *arguments);
  command.final_callback(
    [&command, arguments, &code]
    {
      Check(command, *arguments);
      code = Run(*arguments);
    });
}
}
