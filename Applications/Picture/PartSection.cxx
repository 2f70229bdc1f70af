// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PartSection.h"

#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"
#include "VoxelSection.h"

#include "Base/Text.h"

namespace bonedecimate
{
namespace
{
std::string PathOf(int part)
{
  return "parts.list." + std::to_string(part);
}

/// A cell of the table.
std::string Cell(const ReportFields& report, int part, const std::string& figure)
{
  const std::string change = PartChange(report, part, figure, " &rarr; ");
  return change.empty() ? "&ndash;" : change;
}
}

std::string PartName(const ReportFields& report, int part)
{
  const std::string path = PathOf(part);
  const std::string label = report.Text(path + ".label");
  if (!label.empty())
  {
    return "label " + NameOfLabel(report, label);
  }
  const auto along = [&](const char* axis)
  { return GroupedText(report.Number(path + ".center." + axis).value_or(0.0), 1); };
  return "component at " + along("0") + ", " + along("1") + ", " + along("2") + " mm";
}

std::string PartChange(
  const ReportFields& report, int part, const std::string& figure, const std::string& arrow)
{
  const std::optional<double> before = report.Number(PathOf(part) + ".input." + figure);
  const std::optional<double> after = report.Number(PathOf(part) + ".output." + figure);
  const auto text = [&figure](double value)
  { return figure.find("thickness") == 0 ? GroupedText(value, 3) : SizeText(value); };
  return before && after ? text(*before) + arrow + text(*after) : std::string();
}

std::string PartSection(const ReportFields& report)
{
  // Area and volume of labels are in a table of their own.
  const bool areLabels = report.Text("parts.kind") == "labels";
  std::vector<std::vector<std::string>> rows = { { "", "triangles before" } };
  if (!areLabels)
  {
    rows[0].insert(rows[0].end(), { "area, mm&sup2;", "volume, mm&sup3;" });
  }
  rows[0].insert(rows[0].end(), { "median thickness, mm", "5 % are thinner than, mm" });
  int part = 0;
  for (; report.Number(PathOf(part) + ".triangles"); ++part)
  {
    rows.push_back({ EscapedXml(PartName(report, part)),
      GroupedText(*report.Number(PathOf(part) + ".triangles")) });
    for (const char* figure : { "area", "volume", "thickness_median", "thickness_percentile_5" })
    {
      const bool isThickness = figure[0] == 't';
      if (isThickness || !areLabels)
      {
        rows.back().push_back(Cell(report, part, figure));
      }
    }
  }
  const std::optional<double> count = report.Number("parts.count");
  return count ? PageBlock("parts",
                   { { "title", areLabels ? "Thickness" : "Area, volume and thickness" },
                     { "kind", report.Text("parts.kind") }, { "count", GroupedText(*count) },
                     { "listed", std::to_string(part) }, { "table", Table(rows) } })
               : std::string();
}
}
