// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certify.h"

#include "Arguments/CommonOptions.h"
#include "Arguments/HelpFormatter.h"
#include "CertificatePage.h"
#include "CommandLine.h"
#include "Figures/BoundText.h"
#include "Files/FileNames.h"
#include "Files/SameFile.h"
#include "Files/StagedFile.h"
#include "Files/SurfaceFiles.h"
#include "Formats/FileChecks.h"
#include "PlainText.h"
#include "Report/JsonReport.h"
#include "ReportFields.h"
#include "Runs/FilterRun.h"
#include "Settings/Settings.h"
#include "Terminal/Interruption.h"
#include "VoxelCertificate.h"

#include "vtkBoneSurfaceDistance.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <CLI/CLI.hpp>

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
  AddLabelMap(app, arguments.Map, "--labels,--label-map",
    "A label map (.nii, .nrrd, .mha, .dcm, .tif, .vti ...): count the voxels that have another "
    "label in "
    "RESULT. REFERENCE may be left out then.");
  AddFile(app, "--json", "JSON", arguments.Json, "Write everything found as JSON.");
  AddFile(app, "--page", "HTML", arguments.Page, "Write a self-contained HTML page for people.");
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
  AddSettings(app, arguments.Settings);
}

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
    if (this->Requested.HasReference())
    {
      this->ReadReference();
    }
    const MillimeterSurface result =
      ReadInput(this->Requested.Result(), this->Requested.Unit, this->Warnings);
    this->Result = result.Surface;
    this->ReportOfResult = ReportFields(result.InFile).Text("proof.sentence");
    this->Filter->SetInputData(1, this->Result);
  }

  void CompareVoxels()
  {
    if (!this->Requested.Map.Path.empty())
    {
      this->Voxels.emplace();
      this->Voxels->Compare(this->Result, this->Requested.Result(), this->Requested.Map,
        this->Requested.Threads, this->Warnings);
    }
  }

  void Compare()
  {
    if (!this->Requested.HasReference())
    {
      return;
    }
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
    const VtkMessages messages = UpdateFilter(
      this->Filter, this->Requested.Quiet ? Progress::Hidden : Progress::Bar, "proving");
    const std::string problem = this->Filter->GetReportText("problem");
    if (!messages.Errors.empty() || !problem.empty())
    {
      throw Failure(ExitCode::InputRejected,
        "'" + BaseName(this->Requested.Files[0]) + "' and '" + BaseName(this->Requested.Files[1]) +
          "' were rejected: " + (messages.Errors.empty() ? problem : messages.Errors.front()));
    }
    AcceptMessages(messages, this->Requested.Files[1], this->Warnings, this->Requested.Unit);
  }

  void Write() const
  {
    const CertificateSubject subject = { this->Requested.HasReference() ? this->Requested.Files[0]
                                                                        : std::string(),
      this->Requested.Result(), this->Requested.Map.Path, this->Requested.Tolerance,
      this->Requested.ToleranceArray, this->Requested.Unit.Name,
      this->Voxels ? this->Voxels->Json() : nlohmann::ordered_json(), this->Warnings,
      this->ReportOfResult, this->Requested.Settings };
    const std::string json = ComposeJsonCertificate(
      this->Requested.HasReference() ? this->Filter->GetOutput() : nullptr, subject);
    if (!this->Requested.Json.empty())
    {
      WriteTextFile(this->Requested.Json, json);
    }
    if (!this->Requested.Page.empty())
    {
      WriteTextFile(this->Requested.Page, ComposeCertificatePage(json));
    }
  }

  void Tell()
  {
    if (this->Requested.Quiet)
    {
      return;
    }
    if (this->Requested.HasReference())
    {
      this->TellDistance();
    }
    if (this->Voxels)
    {
      this->Voxels->Print();
    }
    if (!this->ReportOfResult.empty())
    {
      std::cout << "report in the file   " << PlainText(this->ReportOfResult) << "\n";
    }
    PrintWarnings(this->Warnings);
  }

  ExitCode Code() const
  {
    if (this->Voxels && this->Voxels->IsViolated())
    {
      return ExitCode::Violated;
    }
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
  void TellDistance() const
  {
    std::cout << "distance             "
              << LowerBoundText(this->Filter->GetLowerBound(), DecimalsOfRounding) << " to "
              << UpperBoundText(this->Filter->GetUpperBound(), DecimalsOfRounding)
              << " mm, two-sided\n";
    this->TellDirection("reference_to_result", "reference -> result  ");
    this->TellDirection("result_to_reference", "result -> reference  ");
    const std::string boundaries = this->Filter->GetReportText("boundaries");
    this->TellDirection("boundary_reference_to_result", "boundary ref -> res  ");
    this->TellDirection("boundary_result_to_reference", "boundary res -> ref  ");
    if (boundaries == "reference_only" || boundaries == "result_only")
    {
      std::cout << "boundaries           only the "
                << (boundaries == "result_only" ? "result" : "reference") << " has some\n";
    }
    for (int i = 0; !this->LeftOut(i).empty(); ++i)
    {
      std::cout << "left out             " << PlainText(this->LeftOut(i)) << "\n";
    }
    this->TellStatus();
    std::cout << "seconds              " << FixedText(this->Value("seconds"), 2) << "\n";
  }

  void ReadReference()
  {
    const std::string& file = this->Requested.Files[0];
    const MillimeterSurface reference = ReadInput(file, this->Requested.Unit, this->Warnings);
    if (!this->Requested.ToleranceArray.empty() &&
      !reference.Surface->GetPointData()->GetArray(this->Requested.ToleranceArray.c_str()))
    {
      Reject(file, "it has no point array '" + this->Requested.ToleranceArray + "'");
    }
    this->Filter->SetInputData(0, reference.Surface);
  }

  /// Empty if there is no such entry.
  std::string LeftOut(int entry) const
  {
    return this->Filter->GetReportText("left_out." + std::to_string(entry) + ".sentence");
  }

  /// Whether all that was left out is known to be within the tolerance.
  bool CoversWhatWasLeftOut() const
  {
    const double tolerance = this->Requested.Tolerance.value_or(0.0);
    for (int i = 0; !this->LeftOut(i).empty(); ++i)
    {
      if (!(this->Value("left_out." + std::to_string(i) + ".distance") <= tolerance))
      {
        return false;
      }
    }
    return true;
  }

  double Value(const std::string& name) const { return this->Filter->GetReportValue(name); }

  void TellDirection(const std::string& path, const std::string& words) const
  {
    const double lower = this->Value(path + ".lower");
    if (std::isnan(lower))
    {
      return;
    }
    std::cout << words << LowerBoundText(lower, DecimalsOfRounding) << " to "
              << UpperBoundText(this->Value(path + ".upper"), DecimalsOfRounding) << " mm";
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

  /// Before the tolerance.
  std::string StatusText() const
  {
    const std::string word = this->Filter->GetStatusAsString();
    return word +
      (this->Filter->GetStatus() == vtkBoneSurfaceDistance::VIOLATED       ? ", not <= "
          : this->Filter->GetStatus() == vtkBoneSurfaceDistance::UNDECIDED ? " whether <= "
                                                                           : " <= ");
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
      std::cout << "tolerance            " << this->StatusText() << map
                << (map.empty() || number.empty() ? "" : " and ") << number
                << (this->CoversWhatWasLeftOut() ? "" : ", but for what was left out") << "\n";
    }
  }

  const CertifyArguments& Requested;
  std::vector<std::string> Warnings;
  vtkSmartPointer<vtkPolyData> Result;
  std::string ReportOfResult; // what it proves, as its file says
  vtkNew<vtkBoneSurfaceDistance> Filter;
  std::optional<VoxelCertificate> Voxels;
};

/// Options that would have no effect.
void CheckTogether(const CLI::App& app, const CertifyArguments& arguments)
{
  for (const char* flag : { "--tolerance", "--tolerance-array", "--gap", "--mean-precision",
         "--first-proof", "--no-means", "--no-boundaries" })
  {
    if (!arguments.HasReference() && app.count(flag) > 0)
    {
      throw Failure(ExitCode::Usage,
        std::string(flag) + " has no effect without a REFERENCE, to which distances are measured");
    }
  }
  CheckLabel(arguments.Map, "--labels");
  CheckSeries(arguments.Map);
  CheckSpacing(arguments.Map);
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
  const bool isAlone = !arguments.Map.Path.empty() && arguments.Files.size() == 1;
  RequireFiles(command, arguments.Files, isAlone ? 1 : 2,
    arguments.Map.Path.empty() ? "REFERENCE RESULT, or a RESULT and --labels MAP"
                               : "a RESULT, or REFERENCE RESULT");
  CheckTogether(command, arguments);
  std::vector<std::string> read = arguments.Files;
  read.push_back(arguments.Map.Path);
  RequireDistinct({ arguments.Page, arguments.Json }, read);
  RequireExtension("--page", arguments.Page, { "html", "htm" });
}

ExitCode Run(const CertifyArguments& arguments)
{
  CertifyRun run(arguments);
  run.Read();
  StopIfInterrupted();
  run.CompareVoxels();
  run.Compare();
  run.Write();
  run.Tell();
  return run.Code();
}
}

void AddCertifyCommand(CLI::App& program, ExitCode& code)
{
  const auto arguments = std::make_shared<CertifyArguments>();
  CLI::App& command = AddCommand(program, "certify", { "[REFERENCE] RESULT [OPTIONS]" },
    "Proves how far two surfaces are from each other: bounds of the largest distance in both "
    "directions, of surfaces and of open boundaries, and where it is. With a label map it counts "
    "the voxels that have another label in RESULT.");
  AddSurfaces(command, arguments->Files, "Two surfaces, or one with --labels");
  AddOptions(command, *arguments);
  command.final_callback(
    [&command, arguments, &code]
    {
      Check(command, *arguments);
      code = Run(*arguments);
    });
}
}
