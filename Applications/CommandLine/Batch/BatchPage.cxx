// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchPage.h"

#include "Base/Text.h"
#include "FilePath.h"
#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"
#include "PlainText.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
/// A path as an address: "a%20b/c.html".
std::string AddressOf(const std::string& path)
{
  std::string address;
  for (const char c : path)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || std::string("/._-").find(c) != std::string::npos)
    {
      address += c;
    }
    else
    {
      char code[4];
      std::snprintf(code, sizeof(code), "%%%02X", static_cast<unsigned int>(byte));
      address += code;
    }
  }
  return address;
}

/// Empty if the file is not there.
std::string LinkTo(const fs::path& file, const fs::path& folder, const std::string& text)
{
  std::error_code ignored;
  return fs::exists(file, ignored) ? "<a href=\"" +
      AddressOf(file.lexically_relative(folder).generic_string()) + "\">" + text + "</a> "
                                   : std::string();
}

std::string LinksOf(const BatchRow& row, const fs::path& folder)
{
  if (row.Report.empty())
  {
    return LinkTo(folder / FilePath(row.Name + ".log"), folder, "log");
  }
  const fs::path report = FilePath(row.Report);
  const fs::path beside = report.parent_path();
  const bool isOfFolder = report.filename() == "report.json"; // which has a page, too
  return (isOfFolder ? LinkTo(beside / "index.html", folder, "page") : "") +
    (row.Output.empty() ? "" : LinkTo(beside / FilePath(row.Output), folder, "surface")) +
    LinkTo(report, folder, "report");
}

std::optional<double> NumberOf(const BatchRow& row, const char* heading)
{
  const bool isThere =
    row.Figures.is_object() && row.Figures.contains(heading) && row.Figures[heading].is_number();
  return isThere ? std::optional(row.Figures[heading].get<double>()) : std::nullopt;
}

/// "at most 0.4999 mm, proved", or what was measured; empty if nothing is known.
std::string Headline(const BatchRow& row)
{
  if (const std::optional<double> upper = NumberOf(row, "proved_mm"))
  {
    const bool isKept = row.Figures["proof_status"] == "proved";
    return "<strong>at most " + BoundText(*upper) + " mm</strong>, proved" +
      (isKept ? "" : ", but perhaps farther than requested");
  }
  const std::optional<double> there = NumberOf(row, "max_input_to_output_mm");
  const std::optional<double> back = NumberOf(row, "max_output_to_input_mm");
  return there && back ? "<strong>" + EscapedXml(MeasuredText(std::max(*there, *back))) +
      " mm or more</strong>, measured"
                       : std::string();
}

std::string Mean(const BatchRow& row)
{
  const std::optional<double> there = NumberOf(row, "mean_input_to_output_mm");
  const std::optional<double> back = NumberOf(row, "mean_output_to_input_mm");
  return there && back ? EscapedXml(MeasuredText(std::max(*there, *back))) : std::string();
}

std::string Count(const BatchRow& row, const char* heading)
{
  const std::optional<double> count = NumberOf(row, heading);
  return count ? GroupedText(*count) : std::string();
}

/// The options of all results, or that they differ.
std::string OptionsOf(const std::vector<BatchRow>& rows)
{
  std::set<std::string> all;
  for (const BatchRow& row : rows)
  {
    if (!row.Report.empty())
    {
      all.insert(row.Options.empty() ? "the defaults" : EscapedXml(PlainText(row.Options)));
    }
  }
  return all.empty()  ? std::string()
    : all.size() == 1 ? "Options: " + *all.begin() + "."
                      : "The results are of different options: see the table in summary.csv.";
}

/// "done" is quiet, everything else stands out.
std::string Status(const BatchRow& row)
{
  return row.Status == "done" || row.Status == "skipped" ? row.Status
                                                         : "<strong>" + row.Status + "</strong>";
}
}

std::string ComposeBatchPage(const std::string& folder, const std::vector<BatchRow>& rowsByName)
{
  std::vector<BatchRow> rows = rowsByName;
  std::stable_partition(rows.begin(), rows.end(),
    [](const BatchRow& row) { return row.Status != "done" && row.Status != "skipped"; });
  std::vector<std::vector<std::string>> cells = { { "name", "status", "how far from the input",
    "mean, mm", "triangles before", "after", "files", "message" } };
  for (const BatchRow& row : rows)
  {
    cells.push_back({ EscapedXml(PlainText(row.Name)), Status(row), Headline(row), Mean(row),
      Count(row, "triangles_in"), Count(row, "triangles_out"), LinksOf(row, FilePath(folder)),
      EscapedXml(PlainText(row.Message)) });
  }
  return PageBlock("batch",
    { { "head", PageBlock("head", { { "title", "Simplified bone surfaces" } }) },
      { "counts", BatchCounts(rows) }, { "options", OptionsOf(rows) }, { "table", Table(cells) } });
}
}
