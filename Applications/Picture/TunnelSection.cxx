// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TunnelSection.h"

#include "Base/Text.h"
#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"

#include <vector>

namespace bonedecimate
{
namespace
{
std::string Millimeters(const ReportFields& report, const std::string& name)
{
  return EscapedXml(MillimeterText(report.Number(name).value_or(0.0)));
}

/// The first of those that were closed.
std::string TunnelTable(const ReportFields& report)
{
  constexpr std::size_t mostShown = 20;
  std::vector<std::vector<std::string>> rows = { { "diameter, mm", "volume of the plug, mm&sup3;",
    "about, mm" } };
  for (std::size_t i = 0; i < mostShown; ++i)
  {
    const std::string path = "tunnels.list." + std::to_string(i);
    if (!report.Number(path + ".diameter"))
    {
      break;
    }
    rows.push_back({ Millimeters(report, path + ".diameter"), Millimeters(report, path + ".volume"),
      PositionText(report, path + ".center.") });
  }
  return rows.size() == 1 ? std::string() : Table(rows);
}
}

std::string TunnelSection(const ReportFields& report)
{
  const auto count = [&report](const char* name)
  { return GroupedText(report.Number(name).value_or(0.0)); };
  if (!report.Number("tunnels.closed"))
  {
    return {};
  }
  return PageBlock("tunnels",
    { { "closed", count("tunnels.closed") },
      { "distance", Millimeters(report, "tunnels.distance") },
      { "before", count("tunnels.genus_before") }, { "after", count("tunnels.genus_after") },
      { "table", TunnelTable(report) } });
}
}
