// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certify.h"

#include "Arguments/CommonOptions.h"
#include "Arguments/HelpFormatter.h"
#include "BoneVolume.h"
#include "CertifyFolders.h"
#include "CertifyRun.h"
#include "CommandLine.h"
#include "Files/FileNames.h"
#include "Files/SameFile.h"
#include "Files/StagedFile.h"
#include "PlainText.h"
#include "Settings/Settings.h"
#include "Terminal/Interruption.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <optional>

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
  AddIsoValue(
    app, [&arguments](double value) { arguments.Iso = value; },
    "REFERENCE is a CT volume (.nii, .nrrd, .mha, .tif, .vti ..., a folder of DICOM files or TIFF "
    "slices), or a folder of them: the bone surface at this Hounsfield value.");
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

bool HasSeveralResults(const CertifyArguments& arguments)
{
  return arguments.Files.size() > 2 || AreFolders(arguments.Files);
}

/// A volume needs a value, and a value a volume.
void CheckReference(const CertifyArguments& arguments)
{
  const bool areFolders = AreFolders(arguments.Files);
  const bool isVolume = arguments.HasReference() && !areFolders && IsVolume(arguments.Files[0]);
  if (isVolume && !arguments.Iso)
  {
    throw Failure(ExitCode::Usage,
      "'" + BaseName(arguments.Files[0]) +
        "' is a volume: --iso takes its bone surface; a label map goes with --labels, and for the "
        "distance to its surface it is extracted first: --segments all --target-reduction 0");
  }
  if (arguments.Iso && !isVolume && !areFolders)
  {
    throw Failure(ExitCode::Usage, "--iso has no effect; it needs a CT volume as REFERENCE");
  }
  if (arguments.Iso && !arguments.ToleranceArray.empty())
  {
    throw Failure(ExitCode::Usage,
      "--tolerance-array names an array of a surface, and the reference is a volume");
  }
}

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
  CheckSeries(arguments.Map, arguments.Files);
  CheckSpacing(arguments.Map, arguments.Files);
  CheckReference(arguments);
  if (arguments.FirstProof && !arguments.HasTolerance())
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
  if (!isAlone && arguments.Files.size() < 2)
  {
    RequireFiles(command, arguments.Files, 2,
      arguments.Map.Path.empty() ? "REFERENCE RESULT..., or a RESULT and --labels MAP"
                                 : "a RESULT, or REFERENCE RESULT");
  }
  CheckTogether(command, arguments);
  std::vector<std::string> read = arguments.Files;
  read.push_back(arguments.Map.Path);
  RequireDistinct({ arguments.Page, arguments.Json }, read);
  if (HasSeveralResults(arguments) && (!arguments.Page.empty() || !arguments.Map.Path.empty()))
  {
    throw Failure(ExitCode::Usage,
      std::string(arguments.Page.empty() ? "--labels" : "--page") +
        " is for one result; several take --json");
  }
  RequireExtension("--page", arguments.Page, { "html", "htm" });
}

/// The certificate of a pair as a row of a table.
CertifiedPair RunPair(const CertifyArguments& arguments, const FilePair& pair)
{
  CertifiedPair row = { pair.Name, ExitCode::InputRejected, pair.Problem, {}, {} };
  if (!pair.Problem.empty())
  {
    return row;
  }
  CertifyArguments one = arguments;
  one.Files = { pair.Reference, pair.Result };
  one.IsOneOfSeveral = true;
  if (!IsVolume(pair.Reference))
  {
    one.Iso.reset();
  }
  try
  {
    CertifyRun run(one);
    run.Read();
    run.Compare();
    row = { pair.Name, run.Code(), run.Line(), run.Json(), run.GetWarnings() };
  }
  catch (const Failure& failure)
  {
    row.Code = failure.Code;
    row.Text = failure.what();
  }
  return row;
}

/// A line, with the warnings below it; if quiet, a line of what is not proved.
void Tell(const CertifiedPair& row, bool quiet)
{
  const std::string line = PlainText(row.Name) + ": " + PlainText(row.Text) + "\n";
  if (quiet)
  {
    std::cerr << (row.Code == ExitCode::Done ? "" : line);
    return;
  }
  std::cout << line;
  for (const std::string& warning : row.Warnings)
  {
    std::cout << "  warning: " << PlainText(warning) << "\n";
  }
  std::cout << std::flush;
}

std::vector<FilePair> PairsOf(const CertifyArguments& arguments)
{
  std::vector<FilePair> pairs = AreFolders(arguments.Files)
    ? FindPairs(arguments.Files[0], arguments.Files[1], arguments.Iso)
    : PairsWithFirst(arguments.Files);
  for (const FilePair& pair : pairs)
  {
    RequireDistinct({ arguments.Json }, { pair.Reference, pair.Result });
  }
  return pairs;
}

ExitCode RunPairs(const CertifyArguments& arguments)
{
  const std::vector<FilePair> pairs = PairsOf(arguments);
  std::optional<StagedFile> json;
  if (!arguments.Json.empty())
  {
    json.emplace(arguments.Json);
  }
  std::vector<CertifiedPair> rows;
  for (const FilePair& pair : pairs)
  {
    rows.push_back(IsInterrupted()
        ? CertifiedPair{ pair.Name, ExitCode::Interrupted, "not compared: interrupted", {}, {} }
        : RunPair(arguments, pair));
    Tell(rows.back(), arguments.Quiet);
  }
  if (json)
  {
    json->WriteText(JsonOfPairs(rows));
    json->Flush();
    json->Commit();
  }
  if (!arguments.Quiet)
  {
    std::cout << CountsOfPairs(rows, arguments.HasTolerance()) << "\n";
  }
  return WorstOfPairs(rows);
}

ExitCode Run(const CertifyArguments& arguments)
{
  if (HasSeveralResults(arguments))
  {
    return RunPairs(arguments);
  }
  CertifyRun run(arguments);
  run.Reserve();
  run.Read();
  StopIfInterrupted();
  run.Compare();
  run.CompareVoxels();
  if (!arguments.HasReference())
  {
    StopIfInterrupted(); // nothing was proved
  }
  run.Write();
  run.Tell();
  return run.Code();
}
}

void AddCertifyCommand(CLI::App& program, ExitCode& code)
{
  const auto arguments = std::make_shared<CertifyArguments>();
  CLI::App& command = AddCommand(program, "certify", { "[REFERENCE] RESULT... [OPTIONS]" },
    "Proves how far two surfaces are from each other: bounds of the largest distance in both "
    "directions, of surfaces and of open boundaries, and where it is. With a label map it counts "
    "the voxels that have another label in RESULT. REFERENCE may be a CT volume with --iso. "
    "Several results are compared with one reference, and of two folders what has the same name.");
  AddSurfaces(command, arguments->Files, "Two or more surfaces, or one with --labels");
  AddOptions(command, *arguments);
  command.final_callback(
    [&command, arguments, &code]
    {
      Check(command, *arguments);
      code = Run(*arguments);
    });
}
}
