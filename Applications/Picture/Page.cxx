// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Page.h"

#include "NumberText.h"
#include "PageParts.h"
#include "ReportFields.h"
#include "SurfaceDistances.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
const std::string Unknown = "not known";
const std::string Notice =
  "This software is not a medical device. Do not base a diagnosis or a treatment on it alone.";

using Value = std::optional<double>;
using Rows = std::vector<std::vector<std::string>>;

std::string CountText(const Value& value)
{
  return value ? GroupedText(*value) : Unknown;
}

std::string LengthText(const Value& value)
{
  return value ? Escape(MillimetreText(*value)) : Unknown;
}

std::string Section(const std::string& title, const std::string& content)
{
  return "<section>\n<h2>" + title + "</h2>\n" + content + "</section>\n";
}

std::string Paragraph(const std::string& text, const std::string& kind = {})
{
  return (kind.empty() ? "<p>" : "<p class=\"" + kind + "\">") + text + "</p>\n";
}

std::string ShareText(const ReportFields& report)
{
  const Value before = report.Number("input.faces");
  const Value after = report.Number("output.faces");
  return before && after && *before > 0.0 ? " (" + GroupedText(100.0 * *after / *before, 1) + " %)"
                                          : "";
}

std::string Figure(const std::string& value, const std::string& meaning)
{
  return "<div><strong>" + value + "</strong>" + meaning + "</div>\n";
}

bool HasDistances(const ReportFields& report)
{
  return report.Number("distance.output_to_input.max") &&
    report.Number("distance.input_to_output.max");
}

double LargestDistance(const ReportFields& report)
{
  return std::max(
    *report.Number("distance.output_to_input.max"), *report.Number("distance.input_to_output.max"));
}

std::string KeyFigures(const ReportFields& report)
{
  const std::string largest =
    HasDistances(report) ? Escape(MillimetreText(LargestDistance(report))) + " mm" : "not measured";
  return "<div class=\"figures\">\n" +
    Figure(CountText(report.Number("output.faces")),
      "triangles, instead of " + CountText(report.Number("input.faces")) + ShareText(report)) +
    Figure(largest, "largest measured distance between the two surfaces") +
    Figure(CountText(report.Number("output.components")) + " of " +
        CountText(report.Number("input.components")),
      "components (separate pieces) kept") +
    "</div>\n";
}

std::string DistanceSentence(const ReportFields& report)
{
  if (!HasDistances(report))
  {
    return "The distances between the two surfaces were not measured.";
  }
  return "No measured place of the original lies farther than " +
    LengthText(report.Number("distance.input_to_output.max")) +
    " mm from the simplified surface, and none of the simplified surface farther than " +
    LengthText(report.Number("distance.output_to_input.max")) +
    " mm from the original. On average it is " +
    LengthText(report.Number("distance.input_to_output.mean")) + " mm one way and " +
    LengthText(report.Number("distance.output_to_input.mean")) + " mm the other.";
}

std::string Summary(const ReportFields& report)
{
  return Paragraph("The simplified surface has " + CountText(report.Number("output.faces")) +
    " triangles instead of " + CountText(report.Number("input.faces")) + ". " +
    DistanceSentence(report) + " " + CountText(report.Number("output.components")) + " of " +
    CountText(report.Number("input.components")) + " components kept.");
}

std::string Picture(const PageSubject& subject)
{
  const std::string image = EmbeddedPng(subject.PictureFile,
    "The bone before and after, and the distance between the two in colours; below, a close-up");
  return image.empty() ? Paragraph("There is no picture of this bone.", "note")
                       : "<div class=\"picture\">" + image + "</div>\n";
}

std::string MeasuringNote(const ReportFields& report)
{
  const std::string sides[] = { "distance.output_to_input", "distance.input_to_output" };
  std::string counts;
  for (const std::string& side : sides)
  {
    const Value density = report.Number(side + ".samples_per_mm2");
    counts += (counts.empty() ? "" : "; ") + CountText(report.Number(side + ".samples")) +
      " samples, " + (density ? ShortText(*density) : Unknown) + " per mm&sup2;";
  }
  return Paragraph(
    "How it was measured: from every point and from samples spread over the area of one surface (" +
      counts +
      ", in the order of the columns) to the nearest place of the other surface. Mean and RMS "
      "(root mean "
      "square) are over the area. The largest value is a lower bound: between the samples a place "
      "may lie "
      "farther.",
    "note");
}

std::string Curve(const PageSubject& subject)
{
  const std::vector<double> sorted = subject.Before
    ? SortedDistances(TrianglesOnly(subject.Before), subject.DistanceArrayName)
    : std::vector<double>();
  if (sorted.empty())
  {
    return {};
  }
  const auto within = [&sorted](double share)
  { return Escape(MillimetreText(Quantile(sorted, share))) + " mm"; };
  return "<figure>\n" + ShareCurve(sorted) +
    "<figcaption>Share of the original's points within a distance of the "
    "result. Half of them lie within " +
    within(0.5) + ", 95 % within " + within(0.95) + ", 99 % within " + within(0.99) +
    " (the dots); the farthest at " + within(1.0) + ".</figcaption>\n</figure>\n";
}

std::string DistanceTable(const ReportFields& report)
{
  Rows rows = { { "mm", "simplified to original", "original to simplified" } };
  const std::pair<const char*, const char*> lines[] = { { "Largest measured", "max" },
    { "Mean", "mean" }, { "RMS", "rms" } };
  for (const auto& [title, name] : lines)
  {
    rows.push_back(
      { title, LengthText(report.Number(std::string("distance.output_to_input.") + name)),
        LengthText(report.Number(std::string("distance.input_to_output.") + name)) });
  }
  return Table(rows);
}

std::string Distances(const PageSubject& subject, const ReportFields& report)
{
  const std::string measured = HasDistances(report)
    ? DistanceTable(report) + MeasuringNote(report)
    : Paragraph("The distances were not measured in this run.");
  return Section("How far the two surfaces are apart", measured + Curve(subject));
}

std::string Surfaces(const ReportFields& report)
{
  Rows rows = { { "", "before", "after" } };
  struct Line
  {
    const char* Title;
    const char* Name;
    int Decimals;
  };
  const Line lines[] = { { "Triangles", "faces", 0 }, { "Points", "points", 0 },
    { "Components (separate pieces)", "components", 0 }, { "Boundary edges", "boundary_edges", 0 },
    { "Edges of three or more triangles", "non_manifold_edges", 0 },
    { "Euler number", "euler_number", 0 }, { "Area, mm&sup2;", "area", 1 },
    { "Volume, mm&sup3;", "volume", 1 } };
  for (const Line& line : lines)
  {
    std::vector<std::string> row = { line.Title };
    for (const char* side : { "input.", "output." })
    {
      const Value value = report.Number(side + std::string(line.Name));
      row.push_back(value ? GroupedText(*value, line.Decimals) : Unknown);
    }
    rows.push_back(row);
  }
  return Section("The two surfaces",
    Table(rows) +
      Paragraph("Before: after " + CountText(report.Number("input.merged_points")) +
          " points equal to another were merged and " +
          CountText(report.Number("input.dropped_triangles")) +
          " triangles without area were left out; the input held " +
          CountText(report.Number("input.faces_read")) +
          " triangles. The volume means something only where the surface is closed.",
        "note"));
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

/// What the doctor found, if it was asked.
std::string Findings(const ReportFields& report)
{
  Rows rows = { { "", "how many", "the first", "what decimation did" } };
  for (std::size_t i = 0; report.Number("findings." + std::to_string(i) + ".count"); ++i)
  {
    const std::string path = "findings." + std::to_string(i);
    const Value length = report.Number(path + ".length");
    rows.push_back({ Escape(report.Text(path + ".sentence")) +
        (length ? " (" + LengthText(length) + " mm)" : std::string()),
      CountText(report.Number(path + ".count")), FirstIds(report, path),
      Escape(report.Text(path + ".severity")) });
  }
  return rows.size() == 1 ? std::string() : Section("What was found in the input", Table(rows));
}

/// What was left out on request, if anything was asked for.
std::string Pruned(const ReportFields& report)
{
  constexpr std::size_t mostShown = 20;
  const Value count = report.Number("pruned.components");
  if (!count)
  {
    return {};
  }
  const std::string text = Paragraph("Left out on request: " + CountText(count) +
    " components of " + CountText(report.Number("pruned.faces")) +
    " triangles. Distances are those of what is left." +
    (*count > 0 ? " The largest of them:" : ""));
  Rows rows = { { "triangles", "longest side, mm", "area, mm&sup2;", "about, mm" } };
  for (std::size_t i = 0; i < mostShown; ++i)
  {
    const std::string path = "pruned.list." + std::to_string(i);
    const Value faces = report.Number(path + ".faces");
    if (!faces)
    {
      break;
    }
    std::string place;
    for (const std::string& name : report.NamesBelow(path + ".place."))
    {
      place += (place.empty() ? "" : ", ") + LengthText(report.Number(name));
    }
    rows.push_back({ CountText(faces), LengthText(report.Number(path + ".size")),
      LengthText(report.Number(path + ".area")), place });
  }
  return Section("What was left out", text + (rows.size() == 1 ? std::string() : Table(rows)));
}

std::string RefusalText(const std::string& cause)
{
  static const std::array<std::pair<const char*, const char*>, 6> sentences = { {
    { "non_manifold", "the surface is not manifold there and stays as it is" },
    { "border", "an open border would leave its line, or the surface be pinched" },
    { "link_condition", "the topology would change" },
    { "fragment", "a fragment would become too small, vanish or turn inside out" },
    { "flip", "a triangle would turn over" },
    { "degenerate", "a triangle would have no area left" },
  } };
  const auto known = std::find_if(sentences.begin(), sentences.end(),
    [&cause](const auto& sentence) { return cause == sentence.first; });
  return known == sentences.end() ? Escape(cause) : known->second;
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
      (value ? GroupedText(*value) : Escape(report.Text(name))) + "</li>";
  }
  return items.empty() ? Unknown : "<ul>" + items + "</ul>";
}

std::string TextOrUnknown(const ReportFields& report, const std::string& name)
{
  const std::string text = report.Text(name);
  return text.empty() ? Unknown : Escape(text);
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

std::string Making(const ReportFields& report)
{
  const Rows rows = { { "What", "Value" },
    { "Why it stopped", TextOrUnknown(report, "stop_sentence") },
    { "Method", TextOrUnknown(report, "options.Mode") },
    { "Software", "vtkBoneDecimate " + TextOrUnknown(report, "version") },
    { "Checksum of the input", TextOrUnknown(report, "input.checksum") },
    { "Time", SecondsText(report) }, { "Edges collapsed", CountText(report.Number("collapses")) },
    { "Collapses refused, by cause", List(report, "refusals.", RefusalText) },
    { "Options (lengths in mm)", List(report, "options.", Escape) } };
  return Section("How it was made", "<div class=\"words\">" + Table(rows) + "</div>\n");
}
}

std::string ComposePage(const PageSubject& subject)
{
  const ReportFields report(subject.Result);
  const std::string title = "Simplified bone surface: " + Escape(subject.Name);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
    title + "</title>\n<style>" + StyleSheet() + "</style>\n</head>\n<body>\n<h1>" + title +
    "</h1>\n" + Paragraph(Notice, "notice") + KeyFigures(report) + Summary(report) +
    Picture(subject) + Distances(subject, report) + Surfaces(report) + Pruned(report) +
    Findings(report) + Making(report) + Paragraph(Notice, "notice") + "</body>\n</html>\n";
}
}
