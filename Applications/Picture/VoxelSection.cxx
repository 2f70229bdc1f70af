// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelSection.h"

#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"

#include <array>

namespace bonedecimate
{
namespace
{
const std::string LabelPath = "voxels.of_";

std::string Count(const ReportFields& report, const std::string& name)
{
  return GroupedText(report.Number(name).value_or(0.0));
}

/// A row for each label; the background is the last.
std::string LabelTable(const ReportFields& report)
{
  const std::string suffix = ".voxels";
  std::vector<std::string> labels;
  for (const std::string& name : report.NamesBelow(LabelPath))
  {
    if (name.size() > suffix.size() &&
      name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0)
    {
      labels.push_back(
        name.substr(LabelPath.size(), name.size() - suffix.size() - LabelPath.size()));
    }
  }
  std::vector<std::vector<std::string>> rows = { { "label", "voxels", "lost", "gained" } };
  for (const std::string& label : labels)
  {
    const std::string path = LabelPath + label;
    rows.push_back(
      { &label == &labels.back() ? label + " (background)" : label, Count(report, path + suffix),
        Count(report, path + ".lost"), Count(report, path + ".gained") });
  }
  return Table(rows);
}

std::string GuardText(const std::string& guard)
{
  return guard == "on" ? " No edit was allowed to change a voxel."
    : guard == "off"   ? " Edits were allowed to change voxels."
                       : "";
}
}

std::string VoxelSection(const ReportFields& report)
{
  return report.Number("voxels.changed")
    ? PageBlock("voxels",
        { { "changed", Count(report, "voxels.changed") },
          { "compared", Count(report, "voxels.compared") },
          { "guard", GuardText(report.Text("voxels.guard")) }, { "table", LabelTable(report) } })
    : std::string();
}
}
