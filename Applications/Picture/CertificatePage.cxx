// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificatePage.h"

#include "Base/Text.h"
#include "CertificateFinding.h"
#include "Figures/BoundText.h"
#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"
#include "PlainText.h"
#include "ReportFields.h"
#include "SurfaceTable.h"
#include "VoxelSection.h"

#include <array>
#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr int Decimals = 6;
constexpr int FewDecimals = 4;

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

/// What is not compared, in a sentence; empty if there is nothing.
std::string ExceptionsText(const ReportFields& report)
{
  const std::string boundaries = report.Text("boundaries");
  const bool areOfOne = ViolatingBoundary(report).empty() &&
    (boundaries == "reference_only" || boundaries == "result_only");
  std::string text = areOfOne      ? "open boundaries, which only one surface has"
    : boundaries == "not_compared" ? "open boundaries, which were not compared"
                                   : "";
  for (int i = 0; report.Number("left_out." + std::to_string(i) + ".count"); ++i)
  {
    text += (text.empty() ? "" : "; ") +
      EscapedXml(report.Text("left_out." + std::to_string(i) + ".sentence"));
  }
  return text.empty() ? text : " Exceptions: " + text + ".";
}

std::string CountOf(const ReportFields& report, const std::string& name)
{
  return GroupedText(report.Number(name).value_or(0.0));
}

/// The components of the result, and how many of the reference it lacks.
std::string ComponentsTile(const ReportFields& report, const std::string& frame)
{
  const std::optional<double> before = report.Number("reference.components");
  const std::optional<double> after = report.Number("result.components");
  int missing = 0;
  while (report.Number("missing." + std::to_string(missing) + ".triangles"))
  {
    ++missing;
  }
  std::string words = "components (separate pieces) in the result";
  if (missing > 0)
  {
    words += "; missing" +
      (missing > 1 ? " " + std::to_string(missing) + ", the largest with " : std::string(": ")) +
      CountOf(report, "missing.0.triangles") + " triangles, " +
      ShortText(report.Number("missing.0.diagonal").value_or(0.0)) + " mm, at " +
      AnatomicalText(PositionOf(report, "missing.0."), frame);
  }
  return FigureTile(CountOf(report, "result.components") +
      (after > before ? " instead of " : " of ") + CountOf(report, "reference.components"),
    words, missing > 0 || after < before);
}

/// How far, and whether pieces are missing.
std::string Headline(const ReportFields& report, const std::string& frame)
{
  const std::optional<double> upper = report.Number("upper");
  if (!upper)
  {
    return {};
  }
  const std::string status = report.Text("status");
  const bool isKept = status == "proved" || status == "not_requested";
  const auto [distance, meaning] = status == "violated"
    ? Violation(report, frame)
    : std::array<std::string, 2>{ "at most " + UpperText(*upper, ToleranceOf(report), FewDecimals) +
          " mm",
        "No point of either surface is farther from the other." };
  std::string tiles;
  if (report.Number("reference.components") && report.Number("result.components"))
  {
    tiles = ComponentsTile(report, frame) +
      FigureTile(CountOf(report, "result.triangles"),
        "triangles; the reference has " + CountOf(report, "reference.triangles"));
  }
  return PageBlock("certificate headline",
    { { "kind", isKept ? "headline" : "headline open" }, { "distance", distance },
      { "meaning", meaning },
      { "status", status == "not_requested" ? "proved" : StatusText(report) },
      { "exceptions", ExceptionsText(report) }, { "tiles", tiles } });
}

/// A mean and its error; empty if it was not measured.
std::string MeanText(const ReportFields& report, const std::string& name)
{
  const std::optional<double> mean = report.Number(name);
  const std::optional<double> error = report.Number(name + "_error");
  return mean && error ? GroupedText(*mean, Decimals) + " &plusmn; " + GroupedText(*error, Decimals)
                       : std::string();
}

/// Where the largest distance was found; empty if its bounds are those of an empty set.
std::string LargestText(const ReportFields& report, const std::string& path)
{
  const std::optional<double> triangle = report.Number(path + "triangle");
  if (!triangle || *triangle < 0.0)
  {
    return {};
  }
  std::string text;
  for (const char* axis : { "x", "y", "z" })
  {
    const std::optional<double> value = report.Number(path + axis);
    text += (text.empty() ? "" : ", ") + (value ? GroupedText(*value, 2) : "");
  }
  return text + " (triangle " + GroupedText(*triangle) + ")";
}

std::string DistanceSection(const ReportFields& report)
{
  if (!report.Number("upper"))
  {
    return {};
  }
  std::vector<std::vector<std::string>> rows = { { "", "largest distance, mm", "at, mm", "mean, mm",
                                                   "RMS, mm" },
    { "both directions", BoundsText(report, ""), "", "", "" } };
  const std::array<std::pair<const char*, const char*>, 4> directions = { {
    { "reference_to_result.", "reference to result" },
    { "result_to_reference.", "result to reference" },
    { "boundary_reference_to_result.", "open boundaries, reference to result" },
    { "boundary_result_to_reference.", "open boundaries, result to reference" },
  } };
  for (const auto& [path, words] : directions)
  {
    const bool hasNone = !report.Number(path + std::string("upper")) &&
      report.Number(path + std::string("triangle")).value_or(-1.0) >= 0.0;
    if (hasNone) // of which the other surface has none
    {
      rows.push_back({ words, "the other has none", LargestText(report, path), "", "" });
    }
    if (report.Number(path + std::string("upper")))
    {
      rows.push_back({ words, BoundsText(report, path), LargestText(report, path),
        MeanText(report, path + std::string("mean")),
        MeanText(report, path + std::string("rms")) });
    }
  }
  return PageBlock("certified distances",
    { { "table", Table(rows) }, { "status", StatusText(report) },
      { "left out", LeftOutList(report) } });
}

/// Empty if the certificate is whole.
std::string StoppedNotice(const ReportFields& report)
{
  const std::string stopped = EscapedXml(report.Text("stopped"));
  return stopped.empty() ? stopped : PageBlock("stopped", { { "sentence", stopped } });
}

std::string SurfaceSection(const ReportFields& report)
{
  return report.Number("reference.triangles") || report.Number("result.triangles")
    ? PageBlock("compared surfaces",
        { { "table",
          SurfaceTable(report, { "reference.", "result." }, { "reference", "result" }) } })
    : std::string();
}

std::string Warnings(const ReportFields& report)
{
  std::string items;
  for (const std::string& name : report.NamesBelow("warnings."))
  {
    items += "<li>" + EscapedXml(report.Text(name)) + "</li>";
  }
  return items.empty() ? items : PageBlock("certificate warnings", { { "items", items } });
}
}

std::string ComposeCertificatePage(
  const std::string& certificate, const PairSubject& pair, const std::string& pictureFile)
{
  const ReportFields report(certificate);
  const std::string name = EscapedXml(PlainText(report.Text("files.result")));
  const std::optional<double> iso = report.Number("files.iso");
  const std::string reference = EscapedXml(PlainText(report.Text("files.reference"))) +
    (iso ? " at " + GroupedText(*iso) + " HU" : "");
  const std::string map = EscapedXml(PlainText(report.Text("files.label_map")));
  const std::string picture = pictureFile.empty()
    ? std::string()
    : EmbeddedPicture(pictureFile, "The reference and the result");
  PairSubject shown = pair;
  shown.Largest = std::array<LargestDistance, 2>{ LargestOf(report, "reference_to_result."),
    LargestOf(report, "result_to_reference.") };
  const std::vector<FarPoint> points = FarthestOfPair(shown);
  shown.Names = { "Reference", "Result" };
  shown.Tolerance = ToleranceOf(report);
  const ViewerHtml viewer = PairViewer(shown, points, picture.size());
  return PageBlock("certificate",
    { { "head", PageBlock("head", { { "title", "Certificate of a bone surface: " + name } }) },
      { "name", name }, { "reference", reference.empty() ? "none" : reference },
      { "label map", map.empty() ? "none" : map },
      { "version", EscapedXml(report.Text("version")) }, { "date", DateText() },
      { "stopped", StoppedNotice(report) }, { "headline", Headline(report, pair.Frame) },
      { "distances", DistanceSection(report) }, { "viewer", viewer.Section },
      { "picture", picture },
      { "where", WhereSection(points, pair.Frame, { "reference", "result" }) },
      { "surfaces", SurfaceSection(report) }, { "voxels", VoxelSection(report) },
      { "warnings", Warnings(report) }, { "viewer script", viewer.Script } });
}
}
