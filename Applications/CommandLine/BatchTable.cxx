// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchTable.h"

#include "BoundText.h"
#include "NumberText.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::json;

/// Columns that come from the report: heading and JSON pointer.
const std::array<std::pair<const char*, const char*>, 11> ReportColumns = { {
  { "triangles_in", "/input/triangles" },
  { "triangles_out", "/output/triangles" },
  { "components_in", "/input/components" },
  { "components_out", "/output/components" },
  { "max_output_to_input_mm", "/distance/output_to_input/max" },
  { "mean_output_to_input_mm", "/distance/output_to_input/mean" },
  { "max_input_to_output_mm", "/distance/input_to_output/max" },
  { "mean_input_to_output_mm", "/distance/input_to_output/mean" },
  { "proved_mm", "/proof/upper" },
  { "proof_status", "/proof/status" },
  { "seconds", "/seconds/total" },
} };

Json ReadReport(const BatchRow& row)
{
  if (row.Report.empty() || (row.Status != "done" && row.Status != "skipped"))
  {
    return Json();
  }
  std::ifstream stream(row.Report, std::ios::binary);
  return Json::parse(stream, nullptr, false);
}

Json ValueAt(const Json& report, const char* pointer)
{
  const Json::json_pointer at(pointer);
  return report.is_object() && report.contains(at) ? report[at] : Json();
}

/// Why a bone failed or was skipped, and what its report warns of.
std::string MessageOf(const BatchRow& row, const Json& report)
{
  std::string text = row.Message;
  for (const Json& warning : ValueAt(report, "/warnings"))
  {
    text += (text.empty() ? "warning: " : "; warning: ") + warning.get<std::string>();
  }
  return text;
}

/// A field with its quotes doubled, in quotes where it needs them.
std::string Quoted(const std::string& text)
{
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
  const std::string blanks(width > text.size() ? width - text.size() : 0, ' ');
  return right ? blanks + text : text + blanks;
}

using TableLine = std::array<std::string, 8>;

TableLine CellsOf(const BatchRow& row)
{
  const Json report = ReadReport(row);
  const auto number = [&report](const char* pointer, auto text)
  {
    const Json value = ValueAt(report, pointer);
    return value.is_number() ? text(value.get<double>()) : std::string("-");
  };
  const auto whole = [](double value) { return GroupedText(value); };
  const auto length = [](double value) { return MillimeterText(value); };
  const auto bound = [](double value) { return UpperBoundText(value, 6); };
  const Json status = ValueAt(report, "/proof/status");
  return { row.Name, row.Status, number("/input/triangles", whole),
    number("/output/triangles", whole), number("/distance/output_to_input/max", length),
    number("/distance/input_to_output/max", length), number("/proof/upper", bound),
    status.is_string() ? status.get<std::string>() : "-" };
}
}

std::string ComposeCsv(const std::vector<BatchRow>& rows)
{
  std::string text = "name,input,status,exit_code";
  for (const auto& column : ReportColumns)
  {
    text += std::string(",") + column.first;
  }
  text += ",message\n";
  for (const BatchRow& row : rows)
  {
    const Json report = ReadReport(row);
    text += Quoted(row.Name) + "," + Quoted(row.Input) + "," + row.Status + "," +
      (row.Status == "not run" ? "" : std::to_string(static_cast<int>(row.Code)));
    for (const auto& column : ReportColumns)
    {
      const Json value = ValueAt(report, column.second);
      text += "," +
        (value.is_number()      ? value.dump()
            : value.is_string() ? Quoted(value.get<std::string>())
                                : "");
    }
    text += "," + Quoted(MessageOf(row, report)) + "\n";
  }
  return text;
}

void PrintTable(const std::vector<BatchRow>& rows)
{
  std::vector<TableLine> lines = { { "name", "status", "triangles", "->", "max out-in mm",
    "max in-out mm", "proved <= mm", "proof" } };
  std::transform(rows.begin(), rows.end(), std::back_inserter(lines), CellsOf);
  std::array<std::size_t, std::tuple_size_v<TableLine>> widths{};
  for (const TableLine& line : lines)
  {
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      widths[i] = std::max(widths[i], line[i].size());
    }
  }
  for (const TableLine& line : lines)
  {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      text += Padded(line[i], widths[i], i > 1) + "  ";
    }
    std::cout << text.substr(0, text.find_last_not_of(' ') + 1) << "\n";
  }
  for (const BatchRow& row : rows)
  {
    const std::string message = MessageOf(row, ReadReport(row));
    if (!message.empty())
    {
      std::cout << row.Name << ": " << message << "\n";
    }
  }
}
}
