// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelSection.h"

#include "Base/Text.h"
#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"

#include <array>
#include <cmath>
#include <vector>

namespace bonedecimate
{
namespace
{
const std::string LabelPath = "voxels.of_";
const std::string SpacingName = "voxel_grid.smallest_spacing";

std::string Count(const ReportFields& report, const std::string& name)
{
  return GroupedText(report.Number(name).value_or(0.0));
}

/// As the report lists them; the background is the last.
std::vector<std::string> Labels(const ReportFields& report)
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
  return labels;
}

/// Rounded down, so that 100 % means all.
std::string PercentageText(double ratio)
{
  return GroupedText(std::floor(ratio * 1e6) / 1e4, ratio < 1.0 ? 4 : 0) + " %";
}

/// A row for each label.
std::string LabelTable(const ReportFields& report)
{
  std::vector<std::vector<std::string>> rows = { { "label", "voxels", "lost", "gained", "kept" } };
  const std::vector<std::string> labels = Labels(report);
  for (const std::string& label : labels)
  {
    const std::string path = LabelPath + label;
    const double voxels = report.Number(path + ".voxels").value_or(0.0);
    const double lost = report.Number(path + ".lost").value_or(0.0);
    rows.push_back(
      { &label == &labels.back() ? label + " (background)" : EscapedXml(NameOfLabel(report, label)),
        Count(report, path + ".voxels"), Count(report, path + ".lost"),
        Count(report, path + ".gained"),
        voxels > 0.0 ? PercentageText(1.0 - lost / voxels) : "&ndash;" });
  }
  return Table(rows);
}

/// In whole sentences, each after a blank; empty if nothing is known.
std::string RatioText(const ReportFields& report)
{
  const std::optional<double> kept = KeptVoxels(report);
  const std::optional<double> bound = BoundInVoxels(report);
  return (kept ? " Of the voxels of all labels " + PercentageText(*kept) + " keep theirs."
               : std::string()) +
    (bound ? " The largest error is " + ShortText(*bound) + " of the smallest voxel spacing, " +
          ShortText(report.Number(SpacingName).value_or(0.0)) + " mm."
           : std::string());
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
          { "guard", GuardText(report.Text("voxels.guard")) }, { "ratio", RatioText(report) },
          { "table", LabelTable(report) } })
    : std::string();
}

std::optional<double> BoundInVoxels(const ReportFields& report)
{
  const std::optional<double> spacing = report.Number(SpacingName);
  const std::optional<double> preset = report.Number("voxel.largest_error");
  const double error =
    preset ? *preset : ParseFinite(report.Text("options.MaximumError")).value_or(0.0);
  return spacing && *spacing > 0.0 && error > 0.0 ? std::optional<double>(error / *spacing)
                                                  : std::nullopt;
}

std::optional<double> KeptVoxels(const ReportFields& report)
{
  const std::vector<std::string> labels = Labels(report);
  double voxels = 0.0;
  double lost = 0.0;
  for (std::size_t i = 0; i + 1 < labels.size(); ++i)
  {
    voxels += report.Number(LabelPath + labels[i] + ".voxels").value_or(0.0);
    lost += report.Number(LabelPath + labels[i] + ".lost").value_or(0.0);
  }
  return voxels > 0.0 ? std::optional<double>(1.0 - lost / voxels) : std::nullopt;
}

std::string NameOfLabel(const ReportFields& report, const std::string& label)
{
  const std::string name = report.Text("label_names." + label);
  return name.empty() ? label : label + " (" + name + ")";
}
}
