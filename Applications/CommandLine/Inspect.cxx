// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Inspect.h"

#include "HelpFormatter.h"
#include "Interruption.h"
#include "Numbers.h"
#include "StagedFile.h"
#include "SurfaceFiles.h"
#include "SurfaceFormat.h"
#include "Words.h"

#include "vtkBoneCheck.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

namespace bonedecimate
{
namespace
{
std::vector<vtkIdType> FirstIds(vtkBoneCheck* check, int finding)
{
  vtkNew<vtkIdList> ids;
  check->GetFirstIds(finding, ids);
  return { ids->begin(), ids->end() };
}

nlohmann::ordered_json Compose(
  vtkBoneCheck* check, const InspectArguments& arguments, const std::vector<std::string>& warnings)
{
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (int i = 0; i < check->GetNumberOfFindings(); ++i)
  {
    nlohmann::ordered_json finding = { { "kind", check->GetWord(i) },
      { "sentence", check->GetSentence(i) }, { "severity", check->GetSeverity(i) },
      { "count", check->GetCount(i) } };
    if (!check->GetIdsOf(i).empty())
    {
      finding["first_" + check->GetIdsOf(i) + "s"] = FirstIds(check, i);
    }
    if (!std::isnan(check->GetLength(i)))
    {
      finding["length_mm"] = check->GetLength(i);
    }
    findings.push_back(finding);
  }
  return { { "file", BaseName(arguments.File) }, { "unit", arguments.Unit.Name },
    { "usable", check->IsUsable() }, { "warnings", warnings }, { "findings", findings } };
}

/// "refused   3 points are not finite: 5, 7, 19"
void Tell(vtkBoneCheck* check, int finding)
{
  std::printf("%-9s %lld %s", check->GetSeverity(finding).c_str(),
    static_cast<long long>(check->GetCount(finding)), check->GetSentence(finding).c_str());
  if (!std::isnan(check->GetLength(finding)))
  {
    std::printf(" (%.6g mm)", check->GetLength(finding));
  }
  if (check->GetWord(finding) == "odd_size")
  {
    std::printf("; --unit tells another unit of the coordinates");
  }
  const std::vector<vtkIdType> first = FirstIds(check, finding);
  const char* before = ": ";
  for (const vtkIdType id : first)
  {
    std::printf("%s%s%lld", before,
      before[0] == ':' ? (check->GetIdsOf(finding) + " ").c_str() : "", static_cast<long long>(id));
    before = ", ";
  }
  const bool isAll = check->GetCount(finding) <= static_cast<vtkIdType>(first.size());
  std::printf("%s\n", first.empty() || isAll ? "" : ", ...");
}

void TellAll(vtkBoneCheck* check, const std::vector<std::string>& warnings)
{
  for (int i = 0; i < check->GetNumberOfFindings(); ++i)
  {
    Tell(check, i);
  }
  for (const std::string& warning : warnings)
  {
    std::printf("warning   %s\n", warning.c_str());
  }
  std::printf("%s\n", check->IsUsable() ? "It can be decimated." : "It cannot be decimated.");
  std::fflush(stdout);
}
}

std::optional<InspectArguments> ParseInspectArguments(int argc, char* argv[])
{
  InspectArguments arguments;
  CLI::App app("Tells what is odd about a surface: kind, how many, the first ids. Changes nothing.",
    "bonedecimate check");
  app.formatter(std::make_shared<HelpFormatter>("FILE [OPTIONS]"));
  app.footer(ExitCodesText());
  app
    .add_option(
      "FILE", arguments.File, WrappedHelp("A surface (obj, stl, ply, vtp, vtk), in mm or --unit."))
    ->type_name("");
  app.add_option("--json", arguments.Json, WrappedHelp("Write everything found as JSON."))
    ->type_name("FILE");
  AddThreads(app, arguments.Threads);
  AddUnit(app, arguments.Unit);
  app.add_flag("--quiet", arguments.Quiet, "Nothing on the standard output.");
  if (!ParseWords(app, WordsOf(argc, argv, 2)))
  {
    return {};
  }
  if (arguments.File.empty())
  {
    throw Failure(ExitCode::Usage, "check takes a FILE");
  }
  std::error_code error;
  if (std::filesystem::equivalent(arguments.Json, arguments.File, error))
  {
    throw Failure(
      ExitCode::Usage, "'" + arguments.Json + "' is the surface; it is not overwritten");
  }
  return arguments;
}

//------------------------------------------------------------------------------
ExitCode RunInspect(const InspectArguments& arguments)
{
  const MillimeterSurface loaded = ReadInMillimeters(arguments.File, arguments.Unit);
  StopIfInterrupted();
  vtkNew<vtkBoneCheck> check;
  check->SetInputData(loaded.Surface);
  check->SetNumberOfThreads(arguments.Threads);
  check->Update();
  StopIfInterrupted();
  if (!arguments.Json.empty())
  {
    WriteTextFile(arguments.Json,
      Compose(check, arguments, loaded.Warnings)
          .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
        "\n");
  }
  if (!arguments.Quiet)
  {
    TellAll(check, loaded.Warnings);
  }
  return check->IsUsable() ? ExitCode::Done : ExitCode::InputRefused;
}
}
