// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JsonReport.h"

#include "DeprecatedNames.h"
#include "FileNames.h"
#include "Report/Report.h"
#include "ReportFields.h"
#include "StagedFile.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

/// What a later run compares: see ReportMatches().
Json CommandLineOf(const ReportSubject& subject)
{
  Json given = Json::object();
  for (const auto& [flag, text] : subject.Given)
  {
    if (flag != "threads")
    {
      given[flag] = text;
    }
  }
  return given;
}
}

ReportSubject SubjectOf(
  const Arguments& arguments, const std::string& input, const std::string& output)
{
  ReportSubject subject;
  subject.Input = BaseName(input);
  subject.Output = BaseName(output);
  subject.Unit = arguments.Unit.Name;
  subject.InputStamp = StampOf(input);
  subject.Given = arguments.Given;
  return subject;
}

std::string ComposeJsonReport(vtkPolyData* result, const ReportSubject& subject)
{
  Json report = Json::parse(ReportJsonOf(result));
  report["seconds"]["read"] = subject.SecondsRead;
  report["seconds"]["write"] = subject.SecondsWrite;
  report["seconds"]["total"] = subject.SecondsTotal;
  report["files"]["input"] = subject.Input;
  report["files"]["input_bytes"] = subject.InputStamp.Bytes;
  report["files"]["input_modified"] = subject.InputStamp.Modified;
  report["files"]["output"] = subject.Output;
  report["files"]["output_bytes"] = subject.OutputBytes;
  report["files"]["unit"] = subject.Unit;
  if (!subject.ProvedFiles.empty())
  {
    report["proof"]["files"] = subject.ProvedFiles;
  }
  report["command_line"] = CommandLineOf(subject);
  report["warnings"] = subject.Warnings;
  AddDeprecatedKeys(report);
  return JsonText(report);
}

std::string ComposeJsonCertificate(vtkPolyData* output, const CertificateSubject& subject)
{
  Json report = output != nullptr ? Json::parse(ReportJsonOf(output, "BoneDecimateCertificate"))
                                  : Json({ { "version", Version() }, { "problem", "" },
                                      { "status", "not_requested" }, { "units", Json::object() } });
  if (!subject.Voxels.is_null())
  {
    report["voxels"] = subject.Voxels;
  }
  for (const auto& [name, file] : { std::pair("reference", &subject.Reference),
         std::pair("result", &subject.Result), std::pair("label_map", &subject.LabelMap) })
  {
    if (!file->empty())
    {
      report["files"][name] = BaseName(*file);
    }
  }
  report["files"]["unit"] = subject.Unit;
  report["warnings"] = subject.Warnings;
  AddDeprecatedKeys(report);
  return JsonText(report);
}

std::string JsonText(const nlohmann::ordered_json& json)
{
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void WriteJsonFile(const std::string& path, const nlohmann::ordered_json& json)
{
  WriteTextFile(path, JsonText(json));
}

bool ReportMatches(
  const std::string& reportFile, const std::string& outputFile, const ReportSubject& subject)
{
  std::ifstream stream(reportFile, std::ios::binary);
  const Json report = Json::parse(stream, nullptr, false);
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(outputFile, error);
  const auto at = [&report](const char* pointer)
  {
    const Json::json_pointer position(pointer);
    return report.contains(position) ? report[position] : Json();
  };
  return !error && report.is_object() && at("/version") == Version() &&
    at("/command_line") == CommandLineOf(subject) && at("/files/input") == subject.Input &&
    at("/files/input_bytes") == subject.InputStamp.Bytes &&
    at("/files/input_modified") == subject.InputStamp.Modified &&
    at("/files/output_bytes") == bytes;
}
}
