// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JsonReport.h"

#include "Report.h"
#include "SurfaceFormat.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

const std::string Prefix = "bonedecimate.";
const std::string CertificatePrefix = "bonedecimate.certificate.";

/// The JSON pointer of a dotted name: "input.faces" lies at "/input/faces".
Json::json_pointer PointerOf(const std::string& name)
{
  std::string path = "/" + name;
  std::replace(path.begin(), path.end(), '.', '/');
  return Json::json_pointer(path);
}

Json ValueOf(vtkAbstractArray* array)
{
  if (vtkStringArray* texts = vtkStringArray::SafeDownCast(array))
  {
    return texts->GetValue(0);
  }
  const vtkVariant value = array->GetVariantValue(0);
  if (vtkDoubleArray::SafeDownCast(array))
  {
    return value.ToDouble(); // what is not finite becomes null
  }
  return static_cast<std::int64_t>(value.ToLongLong());
}

void AddFieldData(Json& report, const std::string& prefix, vtkFieldData* fields)
{
  Json units = Json::object();
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = fields->GetAbstractArray(i);
    const std::string arrayName = array->GetName() ? array->GetName() : "";
    if (arrayName.compare(0, prefix.size(), prefix) != 0 || array->GetNumberOfValues() == 0)
    {
      continue;
    }
    const std::string name = arrayName.substr(prefix.size());
    report[PointerOf(name)] = ValueOf(array);
    if (array->HasAComponentName() && array->GetComponentName(0))
    {
      units[name] = array->GetComponentName(0);
    }
  }
  report["units"] = units;
}

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
  Json report = Json::object();
  AddFieldData(report, Prefix, result->GetFieldData());
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
  // A name that is not UTF-8 is no reason to have no report.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string ComposeJsonCertificate(vtkPolyData* output, const std::string& reference,
  const std::string& result, const std::string& unit, const std::vector<std::string>& warnings)
{
  Json report = Json::object();
  AddFieldData(report, CertificatePrefix, output->GetFieldData());
  report["files"]["reference"] = BaseName(reference);
  report["files"]["result"] = BaseName(result);
  report["files"]["unit"] = unit;
  report["warnings"] = warnings;
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
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
    const Json::json_pointer place(pointer);
    return report.contains(place) ? report[place] : Json();
  };
  return !error && report.is_object() && at("/version") == Version() &&
    at("/command_line") == CommandLineOf(subject) && at("/files/input") == subject.Input &&
    at("/files/input_bytes") == subject.InputStamp.Bytes &&
    at("/files/input_modified") == subject.InputStamp.Modified &&
    at("/files/output_bytes") == bytes;
}
}
