// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JsonReport.h"

#include "FilePath.h"
#include "Files/FileNames.h"
#include "Files/StagedFile.h"
#include "ReportFields.h"
#include "ReportOfSurface.h"
#include "Run/Report/Report.h"
#include "VoxelSection.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

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

/// Null for what is not known.
template <typename Value>
Json ValueOrNull(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json();
}

Json JsonOf(const ModelGridRecord& model)
{
  return { { "sentence", model.Sentence }, { "spacing", model.Spacing },
    { "dimensions", model.Dimensions }, { "chance", model.Chance },
    { "changed_copies", model.Different },
    { "voxels_of_file",
      { { "compared", model.OfFile.Compared }, { "changed", model.OfFile.Changed } } },
    { "distance_to_file", model.OfFile.Distance } };
}

Json JsonOf(const SegmentRecord& segment)
{
  Json json = { { "label", segment.Label.Value }, { "name", segment.Label.Name },
    { "color", ValueOrNull(segment.Label.Color) }, { "triangles", segment.Triangles },
    { "components", segment.Volumes.size() } };
  constexpr std::size_t mostListed = 32;
  json["volumes"] = std::vector<double>(segment.Volumes.begin(),
    segment.Volumes.begin() +
      static_cast<std::ptrdiff_t>(std::min(segment.Volumes.size(), mostListed)));
  if (segment.Changed)
  {
    json["changed_before"] = JsonOfPieces(*segment.Changed);
  }
  if (!segment.File.empty())
  {
    json["file"] = segment.File;
    json["bytes"] = segment.Bytes;
  }
  return json;
}

Json JsonOf(const std::vector<SegmentRecord>& segments, vtkPolyData* result)
{
  const ReportFields fields(result);
  Json json = { { "bound_in_voxels", ValueOrNull(BoundInVoxels(fields)) },
    { "kept_voxels", ValueOrNull(KeptVoxels(fields)) }, { "list", Json::array() } };
  for (const SegmentRecord& segment : segments)
  {
    json["list"].push_back(JsonOf(segment));
  }
  return json;
}

Json ValueAt(const Json& report, const char* pointer)
{
  const Json::json_pointer position(pointer);
  return report.is_object() && report.contains(position) ? report[position] : Json();
}

/// The size of an output file; of a folder, the files of its segments together. None if one of them
/// is missing.
std::optional<std::uintmax_t> BytesOf(const std::string& output, const Json& report)
{
  std::error_code error;
  if (!std::filesystem::is_directory(FilePath(output), error))
  {
    const std::uintmax_t bytes = std::filesystem::file_size(FilePath(output), error);
    return error ? std::nullopt : std::optional<std::uintmax_t>(bytes);
  }
  std::uintmax_t bytes = 0;
  for (const Json& segment : ValueAt(report, "/segments/list"))
  {
    const bool hasFile =
      segment.is_object() && segment.contains("file") && segment["file"].is_string();
    bytes += hasFile ? std::filesystem::file_size(
                         FilePath(output) / FilePath(segment["file"].get<std::string>()), error)
                     : 0;
    if (error)
    {
      return std::nullopt;
    }
  }
  return bytes;
}

Json JsonIn(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return Json::parse(stream, nullptr, false);
}

bool OutputMatches(const Json& report, const std::string& outputFile)
{
  const Json written = ValueAt(report, "/files/output_bytes");
  const std::optional<std::uintmax_t> bytes =
    written.is_number() ? BytesOf(outputFile, report) : std::nullopt;
  return bytes && written == *bytes;
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
  subject.Settings = arguments.Settings;
  return subject;
}

std::string ComposeJsonReport(vtkPolyData* result, const ReportSubject& subject)
{
  Json report = ReportOf(result);
  report["seconds"]["read"] = subject.SecondsRead;
  report["seconds"]["write"] = subject.SecondsWrite;
  report["seconds"]["total"] = subject.SecondsTotal;
  report["files"]["input"] = subject.Input;
  report["files"]["input_bytes"] = subject.InputStamp.Bytes;
  report["files"]["input_modified"] = subject.InputStamp.Modified;
  report["files"]["output"] = subject.Output;
  report["files"]["output_bytes"] = subject.OutputBytes;
  report["files"]["unit"] = subject.Unit;
  if (!subject.CoordinateSystem.empty())
  {
    report["files"]["coordinate_system"] = subject.CoordinateSystem;
  }
  if (!subject.ProvedFiles.empty())
  {
    report["proof"]["files"] = subject.ProvedFiles;
  }
  report["command_line"] = CommandLineOf(subject);
  AddSettingsTo(report, subject.Settings);
  report["warnings"] = subject.Warnings;
  report["notes"] = subject.Notes;
  if (subject.Slabs)
  {
    report["slabs"] = { { "count", subject.Slabs->Slabs },
      { "largest_triangles", subject.Slabs->MaxSlab },
      { "unproved", subject.Slabs->UnprovedSlabs } };
  }
  if (subject.Specks.Components > 0)
  {
    report["specks"] = { { "size", subject.Specks.Size }, { "components", subject.Specks.Specks },
      { "area_ratio", subject.Specks.AreaRatio } };
  }
  if (subject.Segments.empty() && !subject.Changed.empty())
  {
    report["changed_before"] = JsonOfPieces(subject.Changed.begin()->second);
  }
  if (subject.ModelGrid)
  {
    report["model_grid"] = JsonOf(*subject.ModelGrid);
  }
  if (!subject.Segments.empty())
  {
    report["segments"] = JsonOf(subject.Segments, result);
  }
  return JsonText(report);
}

std::string ComposeJsonCertificate(
  const std::string& certificate, const CertificateSubject& subject)
{
  Json report = !certificate.empty()
    ? Json::parse(certificate)
    : Json({ { "version", Version() }, { "problem", "" }, { "status", "not_requested" },
        { "units", Json::object() } });
  if (subject.Tolerance)
  {
    report["tolerance"] = *subject.Tolerance;
    report["units"]["tolerance"] = "mm";
  }
  if (!subject.ToleranceArray.empty())
  {
    report["tolerance_array"] = subject.ToleranceArray;
  }
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
  if (subject.Iso)
  {
    report["files"]["iso"] = *subject.Iso;
  }
  report["files"]["unit"] = subject.Unit;
  report["warnings"] = subject.Warnings;
  if (!subject.ReportOfResult.empty())
  {
    report["report_in_file"] = subject.ReportOfResult;
  }
  AddSettingsTo(report, subject.Settings);
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
  const Json report = JsonIn(reportFile);
  return OutputMatches(report, outputFile) && ValueAt(report, "/version") == Version() &&
    ValueAt(report, "/command_line") == CommandLineOf(subject) &&
    ValueAt(report, "/files/input") == subject.Input &&
    ValueAt(report, "/files/input_bytes") == subject.InputStamp.Bytes &&
    ValueAt(report, "/files/input_modified") == subject.InputStamp.Modified;
}

std::optional<std::map<std::string, std::string>> OptionsOfReport(
  const std::string& reportFile, const std::string& outputFile, const std::string& inputFile)
{
  const Json report = JsonIn(reportFile);
  const Json given = ValueAt(report, "/command_line");
  if (!OutputMatches(report, outputFile) || !given.is_object() ||
    ValueAt(report, "/files/input") != BaseName(inputFile))
  {
    return std::nullopt;
  }
  std::map<std::string, std::string> options;
  for (const auto& [flag, text] : given.items())
  {
    options[flag] = text.is_string() ? text.get<std::string>() : text.dump();
  }
  return options;
}

bool OutputMatches(const std::string& reportFile, const std::string& outputFile)
{
  return OutputMatches(JsonIn(reportFile), outputFile);
}
}
