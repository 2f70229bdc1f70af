// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificatePage.h"

#include "Base/Text.h"
#include "Figures/BoundText.h"
#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"
#include "PlainText.h"
#include "ReportFields.h"
#include "VoxelSection.h"

#include <array>
#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr int Decimals = 6;

std::string BoundsText(const ReportFields& report, const std::string& path)
{
  const std::optional<double> lower = report.Number(path + "lower");
  const std::optional<double> upper = report.Number(path + "upper");
  return (lower ? LowerBoundText(*lower, Decimals) : "not known") + " to " +
    (upper ? UpperBoundText(*upper, Decimals) : "not known");
}

/// The tolerance of all points, of each point, or both.
std::string StatusText(const ReportFields& report)
{
  const std::string status = report.Text("status");
  const std::string length = report.Text("tolerance");
  const std::string array = EscapedXml(report.Text("tolerance_array"));
  if (status == "not_requested")
  {
    return "No tolerance was given.";
  }
  return "The tolerance" +
    (array.empty() ? " of " + length + " mm"
                   : " of each point (" + array + ")" +
          (length.empty() ? "" : ", at most " + length + " mm,")) +
    " is " + status + ".";
}

/// As a list; empty if nothing was left out.
std::string LeftOutList(const ReportFields& report)
{
  std::string items;
  for (int i = 0; report.Number("left_out." + std::to_string(i) + ".count"); ++i)
  {
    items +=
      "<li>" + EscapedXml(report.Text("left_out." + std::to_string(i) + ".sentence")) + "</li>";
  }
  return items.empty() ? items
                       : "<p>Not compared, because it is no surface:</p><ul>" + items + "</ul>";
}

std::string DistanceSection(const ReportFields& report)
{
  if (!report.Number("upper"))
  {
    return {};
  }
  std::vector<std::vector<std::string>> rows = { { "", "largest distance, mm", "mean, mm" },
    { "both directions", BoundsText(report, ""), "" } };
  const std::array<std::pair<const char*, const char*>, 4> directions = { {
    { "reference_to_result.", "reference to result" },
    { "result_to_reference.", "result to reference" },
    { "boundary_reference_to_result.", "open boundaries, reference to result" },
    { "boundary_result_to_reference.", "open boundaries, result to reference" },
  } };
  for (const auto& [path, words] : directions)
  {
    if (report.Number(path + std::string("upper")))
    {
      const std::optional<double> mean = report.Number(path + std::string("mean"));
      rows.push_back({ words, BoundsText(report, path), mean ? GroupedText(*mean, Decimals) : "" });
    }
  }
  return PageBlock("certified distances",
    { { "table", Table(rows) }, { "status", StatusText(report) },
      { "left out", LeftOutList(report) } });
}

std::string Warnings(const ReportFields& report)
{
  std::string items;
  for (const std::string& name : report.NamesBelow("warnings."))
  {
    items += "<li>" + EscapedXml(report.Text(name)) + "</li>";
  }
  return items.empty() ? items : "<ul>" + items + "</ul>";
}
}

std::string ComposeCertificatePage(const std::string& certificate)
{
  const ReportFields report(certificate);
  const std::string name = EscapedXml(PlainText(report.Text("files.result")));
  const std::optional<double> iso = report.Number("files.iso");
  const std::string reference = EscapedXml(PlainText(report.Text("files.reference"))) +
    (iso ? " at " + GroupedText(*iso) + " HU" : "");
  const std::string map = EscapedXml(PlainText(report.Text("files.label_map")));
  return PageBlock("certificate",
    { { "head", PageBlock("head", { { "title", "Certificate of a bone surface: " + name } }) },
      { "name", name }, { "reference", reference.empty() ? "none" : reference },
      { "label map", map.empty() ? "none" : map },
      { "version", EscapedXml(report.Text("version")) }, { "distances", DistanceSection(report) },
      { "voxels", VoxelSection(report) }, { "warnings", Warnings(report) } });
}
}
