// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Diagnose.h"

#include "Arguments/CommonOptions.h"
#include "CommandLine.h"
#include "Files/FileNames.h"
#include "Files/SameFile.h"
#include "Report/JsonReport.h"
#include "Runs/FilterRun.h"
#include "Settings/Settings.h"
#include "Terminal/Interruption.h"

#include "vtkBoneDiagnostics.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>

namespace bonedecimate
{
namespace
{
std::vector<vtkIdType> FirstIds(vtkBoneDiagnostics* filter, int diagnostic)
{
  vtkNew<vtkIdList> ids;
  filter->GetFirstIds(diagnostic, ids);
  return { ids->begin(), ids->end() };
}

nlohmann::ordered_json Compose(vtkBoneDiagnostics* filter, const DiagnoseArguments& arguments,
  const std::vector<std::string>& warnings)
{
  nlohmann::ordered_json diagnostics = nlohmann::ordered_json::array();
  for (int i = 0; i < filter->GetNumberOfDiagnostics(); ++i)
  {
    nlohmann::ordered_json diagnostic = { { "kind", filter->GetWord(i) },
      { "sentence", filter->GetSentence(i) }, { "severity", filter->GetSeverity(i) },
      { "count", filter->GetCount(i) } };
    if (!filter->GetIdsOf(i).empty())
    {
      diagnostic["first_" + filter->GetIdsOf(i) + "s"] = FirstIds(filter, i);
    }
    if (!std::isnan(filter->GetLength(i)))
    {
      diagnostic["length_mm"] = filter->GetLength(i);
    }
    diagnostics.push_back(diagnostic);
  }
  nlohmann::ordered_json leftOut = nlohmann::ordered_json::array();
  for (int i = 0; i < filter->GetNumberOfLeftOut(); ++i)
  {
    leftOut.push_back({ { "kind", filter->GetLeftOutKind(i) },
      { "count", filter->GetLeftOutCount(i) }, { "sentence", filter->GetLeftOutSentence(i) } });
  }
  return { { "file", BaseName(arguments.Files[0]) }, { "unit", arguments.Unit.Name },
    { "usable", filter->IsUsable() }, { "warnings", warnings }, { "left_out", leftOut },
    { "diagnostics", diagnostics } };
}

/// "rejected   3 points are not finite: 5, 7, 19"
void Tell(vtkBoneDiagnostics* filter, int diagnostic)
{
  const bool isCounted = filter->GetWord(diagnostic) != "odd_size";
  std::cout << std::left << std::setw(9) << filter->GetSeverity(diagnostic) << " "
            << (isCounted ? std::to_string(filter->GetCount(diagnostic)) + " " : "")
            << filter->GetSentence(diagnostic);
  if (!std::isnan(filter->GetLength(diagnostic)))
  {
    std::cout << " (" << filter->GetLength(diagnostic) << " mm)";
  }
  if (!isCounted)
  {
    std::cout << "; --unit tells another unit of the coordinates";
  }
  const std::vector<vtkIdType> first = FirstIds(filter, diagnostic);
  std::string before = ": " + filter->GetIdsOf(diagnostic) + " ";
  for (const vtkIdType id : first)
  {
    std::cout << before << id;
    before = ", ";
  }
  const bool isAll = filter->GetCount(diagnostic) <= static_cast<vtkIdType>(first.size());
  std::cout << (first.empty() || isAll ? "" : ", ...") << "\n";
}

void TellAll(vtkBoneDiagnostics* filter, const std::vector<std::string>& warnings)
{
  for (int i = 0; i < filter->GetNumberOfDiagnostics(); ++i)
  {
    Tell(filter, i);
  }
  for (int i = 0; i < filter->GetNumberOfLeftOut(); ++i)
  {
    std::cout << "left out  " << filter->GetLeftOutSentence(i) << "\n";
  }
  for (const std::string& warning : warnings)
  {
    std::cout << "warning   " << warning << "\n";
  }
  std::cout << (filter->IsUsable() ? "It can be decimated." : "It cannot be decimated.") << "\n";
}

ExitCode Run(const DiagnoseArguments& arguments)
{
  std::vector<std::string> warnings;
  const MillimeterSurface loaded = ReadInput(arguments.Files[0], arguments.Unit, warnings);
  StopIfInterrupted();
  vtkNew<vtkBoneDiagnostics> filter;
  filter->SetInputData(loaded.Surface);
  filter->SetNumberOfThreads(arguments.Threads);
  AcceptMessages(
    UpdateFilter(filter, Progress::Hidden), arguments.Files[0], warnings, arguments.Unit);
  if (!arguments.Json.empty())
  {
    nlohmann::ordered_json report = Compose(filter, arguments, warnings);
    AddSettingsTo(report, arguments.Settings);
    WriteJsonFile(arguments.Json, report);
  }
  if (!arguments.Quiet)
  {
    TellAll(filter, warnings);
  }
  return filter->IsUsable() ? ExitCode::Done : ExitCode::InputRejected;
}
}

void AddDiagnoseCommand(CLI::App& program, ExitCode& code)
{
  const auto arguments = std::make_shared<DiagnoseArguments>();
  CLI::App& command = AddCommand(program, "diagnose", { "FILE [OPTIONS]" },
    "Lists what is unusual about a surface: kind, count, first ids. Changes nothing.");
  AddSurfaces(command, arguments->Files, "A surface");
  AddFile(command, "--json", "JSON", arguments->Json, "Write everything found as JSON.");
  AddThreads(command, arguments->Threads);
  AddUnit(command, arguments->Unit);
  AddQuiet(command, arguments->Quiet);
  AddSettings(command, arguments->Settings);
  command.final_callback(
    [&command, arguments, &code]
    {
      RequireFiles(command, arguments->Files, 1, "one FILE");
      RequireDistinct({ arguments->Json }, arguments->Files);
      code = Run(*arguments);
    });
}
}
