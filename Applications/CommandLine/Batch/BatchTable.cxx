// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchTable.h"

#include "BatchPage.h"
#include "FilePath.h"
#include "Files/StagedFile.h"
#include "NumberText.h"
#include "PlainText.h"
#include "Segments/SegmentRows.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::json;

struct ReportColumn
{
  const char* Heading;
  const char* Pointer; ///< In the JSON report.
};

const std::array<ReportColumn, 13> ReportColumns = { {
  { "triangles_in", "/input/triangles" },
  { "triangles_out", "/output/triangles" },
  { "components_in", "/input/components" },
  { "components_out", "/output/components" },
  { "max_output_to_input_mm", "/distance/output_to_input/max" },
  { "mean_output_to_input_mm", "/distance/output_to_input/mean" },
  { "max_input_to_output_mm", "/distance/input_to_output/max" },
  { "mean_input_to_output_mm", "/distance/input_to_output/mean" },
  { "bound_mm", "/proof/tolerance" },
  { "proved_mm", "/proof/upper" },
  { "proof_status", "/proof/status" },
  { "voxels_changed", "/voxels/changed" },
  { "seconds", "/seconds/total" },
} };

Json ValueAt(const Json& report, const char* pointer)
{
  const Json::json_pointer at(pointer);
  return report.is_object() && report.contains(at) ? report[at] : Json();
}

/// What tables take for the beginning of a formula is text behind an apostrophe.
std::string WithoutFormula(const std::string& text)
{
  const bool isFormula =
    !text.empty() && std::string_view("=+-@").find(text[0]) != std::string::npos;
  return isFormula ? "'" + text : text;
}

/// A field with its quotes doubled, in quotes where it needs them.
std::string QuotedField(const std::string& field)
{
  const std::string text = WithoutFormula(PlainText(field));
  if (text.find_first_of(",\"\r\n") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += c;
    quoted += c == '"' ? "\"" : "";
  }
  return quoted + "\"";
}

std::string Padded(const std::string& text, std::size_t width, bool right)
{
  const std::size_t characters = NumberOfCharacters(text);
  const std::string blanks(width > characters ? width - characters : 0, ' ');
  return right ? blanks + text : text + blanks;
}

/// A column of the table for people.
struct TableColumn
{
  const char* Title;
  std::size_t Width;
  const char* Heading; ///< Column of summary.csv that has the figure.
  std::string (*Text)(double);
};

const std::array<TableColumn, 6> TableColumns = { {
  { "triangles", 10, "triangles_in", [](double value) { return GroupedText(value); } },
  { "->", 10, "triangles_out", [](double value) { return GroupedText(value); } },
  { "max out-in mm", 13, "max_output_to_input_mm", MeasuredText },
  { "max in-out mm", 13, "max_input_to_output_mm", MeasuredText },
  { "seconds", 8, "seconds", [](double value) { return GroupedText(value, 1); } },
  { "at most mm", 10, "proved_mm", BoundText },
} };

constexpr std::size_t StatusWidth = 11; // characters of "interrupted"
constexpr std::size_t ProofWidth = 10;  // characters of "not proved"

Json FigureOf(const BatchRow& row, const char* heading)
{
  return row.Figures.is_object() && row.Figures.contains(heading) ? row.Figures[heading] : Json();
}

std::string FieldOf(const Json& value)
{
  return value.is_number() ? value.dump()
    : value.is_string()    ? QuotedField(value.get<std::string>())
                           : "";
}

/// The surface below the folder of the table, or the folder of several.
std::string OutputBelow(const std::string& folder, const BatchRow& row)
{
  if (row.Report.empty())
  {
    return {};
  }
  namespace fs = std::filesystem;
  const fs::path report = FilePath(row.Report).lexically_relative(FilePath(folder));
  const fs::path output = FilePath(row.Output).filename();
  const bool isFolder =
    report.filename() == "report.json" && report.parent_path().filename() == output;
  return isFolder ? report.parent_path().generic_string() + "/"
                  : (report.parent_path() / output).generic_string();
}

std::string WithoutBlanksAtEnd(const std::string& line)
{
  return line.substr(0, line.find_last_not_of(' ') + 1);
}
}

void TakeReport(BatchRow& row, const std::string& report)
{
  std::ifstream stream(report, std::ios::binary);
  const Json json = Json::parse(stream, nullptr, false);
  for (const ReportColumn& column : ReportColumns)
  {
    row.Figures[column.Heading] = ValueAt(json, column.Pointer);
  }
  for (const char* count : { "triangles", "components" }) // before they were pruned
  {
    const Json pruned = ValueAt(json, (std::string("/pruned/") + count).c_str());
    Json& before = row.Figures[std::string(count) + "_in"];
    before = pruned.is_number() && before.is_number()
      ? Json(before.get<std::int64_t>() + pruned.get<std::int64_t>())
      : before;
  }
  row.Segments = SegmentRows(json);
  row.Report = report;
  row.Options.clear();
  const Json given = ValueAt(json, "/command_line");
  for (const auto& [flag, value] : given.items())
  {
    row.Options += (row.Options.empty() ? "" : " ") + flag + "=" +
      (value.is_string() ? value.get<std::string>() : value.dump());
  }
  const Json output = ValueAt(json, "/files/output");
  row.Output = output.is_string() ? output.get<std::string>() : std::string();
  for (const Json& warning : ValueAt(json, "/warnings"))
  {
    row.Message += (row.Message.empty() ? "warning: " : "; warning: ") +
      (warning.is_string() ? warning.get<std::string>() : warning.dump());
  }
}

std::string ComposeCsv(const std::string& folder, const std::vector<BatchRow>& rows)
{
  std::string text = "name,input,output,status,exit_code";
  for (const ReportColumn& column : ReportColumns)
  {
    text += std::string(",") + column.Heading;
  }
  text += ",options,message\n";
  for (const BatchRow& row : rows)
  {
    text += QuotedField(row.Name) + "," + QuotedField(row.Input) + "," +
      QuotedField(OutputBelow(folder, row)) + "," + row.Status + "," +
      (row.Status == "not run" ? "" : std::to_string(static_cast<int>(row.Code)));
    for (const ReportColumn& column : ReportColumns)
    {
      text += "," + FieldOf(FigureOf(row, column.Heading));
    }
    text += "," + QuotedField(row.Options) + "," + QuotedField(row.Message) + "\n";
  }
  return text;
}

std::string ComposeSegmentsCsv(const std::vector<BatchRow>& rows)
{
  std::string text;
  for (const BatchRow& row : rows)
  {
    for (const Json& segment : row.Segments)
    {
      text += QuotedField(row.Name);
      for (const char* column : SegmentColumns)
      {
        text += "," + FieldOf(ValueAt(segment, (std::string("/") + column).c_str()));
      }
      text += '\n';
    }
  }
  std::string heading = "name";
  for (const char* column : SegmentColumns)
  {
    heading += std::string(",") + column;
  }
  return text.empty() ? text : heading + "\n" + text;
}

std::string WriteTables(const std::string& folder, const std::vector<BatchRow>& rows)
{
  const std::string summary = (FilePath(folder) / "summary.csv").string();
  WriteTextFile(summary, ComposeCsv(folder, rows));
  WriteTextFile((FilePath(folder) / "summary.html").string(), ComposeBatchPage(folder, rows));
  const std::string segments = ComposeSegmentsCsv(rows);
  if (!segments.empty())
  {
    WriteTextFile((FilePath(folder) / "segments.csv").string(), segments);
  }
  return summary;
}

std::size_t WidthOfNames(const std::vector<BatchRow>& rows)
{
  constexpr std::size_t longest = 60;
  std::size_t width = NumberOfCharacters("name");
  for (const BatchRow& row : rows)
  {
    width = std::max(width, std::min(NumberOfCharacters(row.Name), longest));
  }
  return width;
}

std::string BatchHeading(std::size_t nameWidth)
{
  std::string line = Padded("name", nameWidth, false) + "  " + Padded("status", StatusWidth, false);
  for (const TableColumn& column : TableColumns)
  {
    line += "  " + Padded(column.Title, column.Width, true);
  }
  return line + "  proof";
}

std::string BatchLine(const BatchRow& row, std::size_t nameWidth)
{
  std::string line =
    Padded(PlainText(row.Name), nameWidth, false) + "  " + Padded(row.Status, StatusWidth, false);
  for (const TableColumn& column : TableColumns)
  {
    const Json value = FigureOf(row, column.Heading);
    line +=
      "  " + Padded(value.is_number() ? column.Text(value.get<double>()) : "-", column.Width, true);
  }
  const Json proof = FigureOf(row, "proof_status");
  line += "  " + Padded(proof.is_string() ? proof.get<std::string>() : "-", ProofWidth, false);
  const std::string separator = row.Note.empty() || row.Message.empty() ? "" : "; ";
  return WithoutBlanksAtEnd(line + "  " + PlainText(row.Note + separator + row.Message));
}

ExitCode WorstCodeOf(const std::vector<BatchRow>& rows)
{
  const auto rank = [](ExitCode code) {
    return code == ExitCode::Done ? 0 : code == ExitCode::LeftOut ? 1 : 1 + static_cast<int>(code);
  };
  ExitCode worst = ExitCode::Done;
  for (const BatchRow& row : rows)
  {
    worst = rank(row.Code) > rank(worst) ? row.Code : worst;
  }
  return worst;
}

std::string BatchCounts(const std::vector<BatchRow>& rows)
{
  std::string text = std::to_string(rows.size()) + (rows.size() == 1 ? " file" : " files");
  std::string separator = ": ";
  for (const char* status : { "done", "skipped", "failed", "interrupted", "not run" })
  {
    const auto count = std::count_if(
      rows.begin(), rows.end(), [status](const BatchRow& row) { return row.Status == status; });
    if (count > 0)
    {
      text += separator + std::to_string(count) + " " + status;
      separator = ", ";
    }
  }
  return text;
}
}
