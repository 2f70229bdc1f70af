// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchPage.h"

#include "Base/Text.h"
#include "Figures/BoundText.h"
#include "FilePath.h"
#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"
#include "PlainText.h"

#include <cctype>
#include <cstdio>
#include <filesystem>

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
    return "";
  }
  const fs::path report = FilePath(row.Report);
  const fs::path beside = report.parent_path();
  const bool isOfFolder = report.filename() == "report.json"; // which has a page, too
  return (isOfFolder ? LinkTo(beside / "index.html", folder, "page") : "") +
    (row.Output.empty() ? "" : LinkTo(beside / FilePath(row.Output), folder, "surface")) +
    LinkTo(report, folder, "report");
}

std::string Figure(const BatchRow& row, const char* heading)
{
  const bool isThere =
    row.Figures.is_object() && row.Figures.contains(heading) && row.Figures[heading].is_number();
  return isThere ? GroupedText(row.Figures[heading].get<double>()) : "";
}

std::string Proved(const BatchRow& row)
{
  const bool isThere = row.Figures.is_object() && row.Figures.contains("proved_mm") &&
    row.Figures["proved_mm"].is_number();
  return isThere ? UpperBoundText(row.Figures["proved_mm"].get<double>(), 6) : "";
}
}

std::string ComposeBatchPage(const std::string& folder, const std::vector<BatchRow>& rows)
{
  std::vector<std::vector<std::string>> cells = { { "name", "status", "triangles before", "after",
    "proved, mm", "files", "message" } };
  for (const BatchRow& row : rows)
  {
    cells.push_back({ EscapedXml(PlainText(row.Name)), row.Status, Figure(row, "triangles_in"),
      Figure(row, "triangles_out"), Proved(row), LinksOf(row, FilePath(folder)),
      EscapedXml(PlainText(row.Message)) });
  }
  return PageBlock("batch",
    { { "head", PageBlock("head", { { "title", "Simplified bone surfaces" } }) },
      { "counts", BatchCounts(rows) }, { "table", Table(cells) } });
}
}
