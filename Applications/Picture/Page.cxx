// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Page.h"

#include "Base/Text.h"
#include "Figures/Rejection.h"
#include "Headline.h"
#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"
#include "PartSection.h"
#include "PlainText.h"
#include "ProofSection.h"
#include "ReportFields.h"
#include "SurfaceDistances.h"
#include "SurfaceTable.h"
#include "TunnelSection.h"
#include "VoxelSection.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
const std::string Unknown = "not known";

using Value = std::optional<double>;
using Rows = std::vector<std::vector<std::string>>;

std::string CountText(const Value& value)
{
  return value ? GroupedText(*value) : Unknown;
}

std::string LengthText(const Value& value)
{
  return value ? EscapedXml(MillimeterText(*value)) : Unknown;
}

bool HasDistances(const ReportFields& report)
{
  return report.Number("distance.output_to_input.max") &&
    report.Number("distance.input_to_output.max");
}

std::string Curve(const std::vector<double>& sorted)
{
  if (sorted.empty())
  {
    return {};
  }
  const auto within = [&sorted](double fraction)
  { return EscapedXml(MeasuredText(Quantile(sorted, fraction))); };
  return PageBlock("curve",
    { { "drawing", DistanceCurve(sorted) }, { "half", within(0.5) }, { "most", within(0.95) },
      { "nearly all", within(0.99) }, { "all", within(1.0) } });
}

std::string DistanceTable(const ReportFields& report)
{
  Rows rows = { { "mm", "simplified to original", "original to simplified" } };
  const std::pair<const char*, const char*> lines[] = { { "Largest measured", "max" },
    { "Mean", "mean" }, { "RMS", "rms" } };
  const auto measured = [&report](const std::string& direction, const char* name)
  {
    const Value value = report.Number("distance." + direction + name);
    return value ? EscapedXml(MeasuredText(*value)) : Unknown;
  };
  for (const auto& [title, name] : lines)
  {
    rows.push_back(
      { title, measured("output_to_input.", name), measured("input_to_output.", name) });
  }
  return Table(rows);
}

std::string Distances(const ReportFields& report)
{
  if (!HasDistances(report))
  {
    return PageBlock("no distances");
  }
  const auto density = [&report](const std::string& direction)
  {
    const Value value = report.Number("distance." + direction + ".samples_per_mm2");
    return value ? ShortText(*value) : Unknown;
  };
  return PageBlock("distances",
    { { "table", DistanceTable(report) },
      { "output samples", CountText(report.Number("distance.output_to_input.samples")) },
      { "output density", density("output_to_input") }, { "proof", ProofClause(report) },
      { "input samples", CountText(report.Number("distance.input_to_output.samples")) },
      { "input density", density("input_to_output") } });
}

/// "a triangle 5, 7, ..."; empty where a kind has no ids.
std::string FirstIds(const ReportFields& report, const std::string& path)
{
  std::string ids;
  for (const char* of : { "point", "triangle" })
  {
    for (const std::string& name : report.NamesBelow(path + ".first_" + of + "s."))
    {
      ids += (ids.empty() ? std::string(of) + " " : ", ") + CountText(report.Number(name));
    }
  }
  return ids;
}

/// Empty if there are none.
std::string Diagnostics(const ReportFields& report)
{
  Rows rows = { { "", "how many", "the first", "what decimation did" } };
  for (std::size_t i = 0; report.Number("diagnostics." + std::to_string(i) + ".count"); ++i)
  {
    const std::string path = "diagnostics." + std::to_string(i);
    const Value length = report.Number(path + ".length");
    rows.push_back({ EscapedXml(report.Text(path + ".sentence")) +
        (length ? " (" + LengthText(length) + " mm)" : std::string()),
      CountText(report.Number(path + ".count")), FirstIds(report, path),
      EscapedXml(report.Text(path + ".severity")) });
  }
  return rows.size() == 1 ? std::string() : PageBlock("diagnostics", { { "table", Table(rows) } });
}

/// The largest of the components that were left out.
std::string PrunedTable(const ReportFields& report)
{
  constexpr std::size_t mostShown = 20;
  Rows rows = { { "triangles", "longest side, mm", "area, mm&sup2;", "about, mm" } };
  for (std::size_t i = 0; i < mostShown; ++i)
  {
    const std::string path = "pruned.list." + std::to_string(i);
    const Value triangles = report.Number(path + ".triangles");
    if (!triangles)
    {
      break;
    }
    rows.push_back({ CountText(triangles), LengthText(report.Number(path + ".size")),
      LengthText(report.Number(path + ".area")), PositionText(report, path + ".center.") });
  }
  return rows.size() == 1 ? std::string() : Table(rows);
}

/// Empty unless components were to be left out.
std::string Pruned(const ReportFields& report)
{
  const Value count = report.Number("pruned.components");
  return count ? PageBlock("pruned",
                   { { "components", CountText(count) },
                     { "triangles", CountText(report.Number("pruned.triangles")) },
                     { "table", PrunedTable(report) } })
               : std::string();
}

/// Empty unless the surface was smoothed.
std::string Smoothing(const ReportFields& report)
{
  if (!report.Number("smoothing.largest_displacement"))
  {
    return {};
  }
  const auto text = [&report](const char* name, int decimals)
  {
    const Value value = report.Number(std::string("smoothing.") + name);
    return value ? GroupedText(*value, decimals) : Unknown;
  };
  const Rows rows = { { "", "before", "after" },
    { "Mean angle between neighboring triangles, degrees", text("angle_before", 1),
      text("angle_after", 1) },
    { "Area, mm&sup2;", text("area_before", 1), text("area_after", 1) } };
  return PageBlock("smoothing",
    { { "largest", LengthText(report.Number("smoothing.largest_displacement")) },
      { "bound", LengthText(report.Number("smoothing.bound")) },
      { "rms", LengthText(report.Number("smoothing.rms_displacement")) },
      { "sharp", text("sharp_points", 0) }, { "table", Table(rows) } });
}

std::string RejectionText(const std::string& cause)
{
  const auto* const known = std::find_if(std::begin(RejectionTable), std::end(RejectionTable),
    [&cause](const RejectionInfo& row) { return cause == row.Word; });
  return known == std::end(RejectionTable) ? EscapedXml(cause) : known->Sentence;
}

/// The entries below a name as "what: value" lines, or nothing.
std::string List(const ReportFields& report, const std::string& beginning,
  std::string (*title)(const std::string&))
{
  std::string items;
  for (const std::string& name : report.NamesBelow(beginning))
  {
    const Value value = report.Number(name);
    items += "<li>" + title(name.substr(beginning.size())) + ": " +
      (value ? GroupedText(*value) : EscapedXml(report.Text(name))) + "</li>";
  }
  return items.empty() ? Unknown : "<ul>" + items + "</ul>";
}

std::string TextOrUnknown(const ReportFields& report, const std::string& name)
{
  const std::string text = report.Text(name);
  return text.empty() ? Unknown : EscapedXml(text);
}

/// Empty unless voxels were to change before the surface was extracted.
std::string ChangesSection(const std::vector<std::string>& changes)
{
  std::string items;
  for (const std::string& change : changes)
  {
    items += "<li>" + EscapedXml(change) + "</li>";
  }
  return items.empty() ? std::string() : PageBlock("changes", { { "items", items } });
}

std::string SecondsText(const ReportFields& report)
{
  const auto text = [&report](const std::string& name)
  {
    const Value value = report.Number("seconds." + name);
    return value ? GroupedText(*value, 2) + " s" : Unknown;
  };
  return text("decimate") + " to simplify, " + text("measure") + " to measure, " + text("total") +
    " in all";
}

std::string RunTable(const ReportFields& report)
{
  return Table({ { "What", "Value" }, { "Why it stopped", TextOrUnknown(report, "stop_sentence") },
    { "Method", TextOrUnknown(report, "options.Mode") },
    { "Software", "vtkBoneDecimate " + TextOrUnknown(report, "version") },
    { "Checksum of the input", TextOrUnknown(report, "input.checksum") },
    { "Time", SecondsText(report) },
    { "Edges collapsed", CountText(report.Number("collapses")) } });
}

std::string MadeSection(const ReportFields& report)
{
  return PageBlock("made",
    { { "table", RunTable(report) }, { "rejections", List(report, "rejections.", RejectionText) },
      { "options", List(report, "options.", EscapedXml) } });
}

std::vector<double> DistancesOfOriginal(const PageSubject& subject)
{
  return subject.Before ? SortedDistances(TrianglesOnly(subject.Before), subject.DistanceArrayName)
                        : std::vector<double>();
}

std::string ModelGridSection(const PageSubject& subject)
{
  return subject.ModelGrid.empty()
    ? std::string()
    : PageBlock("model grid", { { "sentence", EscapedXml(subject.ModelGrid) } });
}

std::string CommandLine(const PageSubject& subject)
{
  return subject.Command.empty()
    ? std::string()
    : PageBlock("command", { { "command", EscapedXml(PlainText(subject.Command)) } });
}
}

std::string ComposePage(const PageSubject& subject)
{
  const ReportFields report(subject.Result);
  const std::string picture = EmbeddedPicture(subject.PictureFile);
  const std::vector<FarPoint> points = FarthestOfPair(subject);
  const std::vector<double> distances = DistancesOfOriginal(subject);
  const ViewerHtml viewer = PairViewer(subject, points, picture.size());
  const PageLabels labels = PageLabelsOf(subject.Before, subject.Result);
  const std::string name = EscapedXml(PlainText(subject.Name));
  const auto count = [&report](const char* entry) { return CountText(report.Number(entry)); };
  return PageBlock("page",
    { { "head", PageBlock("head", { { "title", "Simplified bone surface: " + name } }) },
      { "name", name }, { "command", CommandLine(subject) },
      { "headline", HeadlineSection(report, distances, labels, subject.Specks) },
      { "specks", SpeckHint(subject.Specks) },
      { "where", WhereSection(points, subject.Frame, { "before", "after" }) },
      { "labels", LabelSection(labels) }, { "smoothing", Smoothing(report) },
      { "parts", PartSection(report) },
      { "voxels", VoxelSection(report) + ChangesSection(subject.Changes) },
      { "model grid", ModelGridSection(subject) }, { "proof", ProofSection(report) },
      { "picture", picture }, { "viewer", viewer.Section }, { "viewer script", viewer.Script },
      { "distances", Distances(report) }, { "curve", Curve(distances) },
      { "surface table", SurfaceTable(report, { "input.", "output." }, { "before", "after" }) },
      { "merged points", count("input.merged_points") },
      { "dropped triangles", count("input.dropped_triangles") },
      { "triangles read", count("input.triangles_read") }, { "pruned", Pruned(report) },
      { "tunnels", TunnelSection(report) }, { "diagnostics", Diagnostics(report) },
      { "made", MadeSection(report) } });
}

//------------------------------------------------------------------------------
void TakeReport(PictureSubject& subject)
{
  const ReportFields report(subject.After);
  subject.Triangles[0] = report.Number("input.triangles");
  subject.LargestDistance = report.Number("distance.input_to_output.max").value_or(0.0);
}
}
