// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProofSection.h"

#include "Base/Text.h"
#include "Figures/BoundText.h"
#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace bonedecimate
{
namespace
{
constexpr int Decimals = 6;

/// Nothing if there is no proof, or none with a bound.
std::optional<std::string> ProvedText(const ReportFields& report)
{
  const std::optional<double> upper = report.Number("proof.upper");
  return upper ? std::optional<std::string>(BoundText(*upper)) : std::nullopt;
}

/// "0.5 mm and the tolerance of each point (Tolerances)"; empty without either.
std::string ToleranceText(const ReportFields& report)
{
  const bool hasLength = report.Number("proof.tolerance").value_or(0.0) > 0.0;
  const std::string array = EscapedXml(report.Text("options.ToleranceArrayName"));
  constexpr std::size_t readable = 8; // characters; those of presets have up to 17
  const std::string exact = report.Text("proof.tolerance");
  const std::string number =
    exact.size() > readable ? MeasuredText(report.Number("proof.tolerance").value_or(0.0)) : exact;
  const std::string length = hasLength ? number + " mm" : "";
  const std::string points = array.empty() ? "" : "the tolerance of each point (" + array + ")";
  return length + (length.empty() || points.empty() ? "" : " and ") + points;
}

std::string StatusText(const ReportFields& report)
{
  const std::string status = report.Text("proof.status");
  return status == "proved" || status == "violated" ? status : "not proved";
}

/// As HTML.
std::string ReasonText(const ReportFields& report)
{
  return EscapedXml(ReasonWithoutProof(report));
}

std::string BoundariesText(const std::string& boundaries)
{
  static const std::pair<const char*, const char*> sentences[] = {
    { "neither", "Neither surface has open boundaries." },
    { "both", "Open boundaries are compared curve to curve." },
    { "reference_only",
      "Not proved: open boundaries. Only the original has some, so their distance has no bound." },
    { "result_only",
      "Not proved: open boundaries. Only the simplified surface has some, so their distance has no "
      "bound." },
    { "not_compared",
      "Not proved: the distance of open boundaries, which are not compared without MergePoints." },
  };
  for (const auto& [word, sentence] : sentences)
  {
    if (boundaries == word)
    {
      return sentence;
    }
  }
  return {};
}

struct LeftOutEntry
{
  std::string Sentence; ///< As HTML.
  bool IsCovered;       ///< By the bound.
};

std::vector<LeftOutEntry> LeftOutEntries(const ReportFields& report)
{
  std::vector<LeftOutEntry> entries;
  for (int i = 0; report.Number("left_out." + std::to_string(i) + ".count"); ++i)
  {
    const std::string path = "left_out." + std::to_string(i);
    const std::optional<double> distance = report.Number(path + ".distance");
    entries.push_back({ EscapedXml(report.Text(path + ".sentence")),
      distance && *distance <= report.Number("proof.upper").value_or(0.0) });
  }
  return entries;
}

std::string LeftOutText(const ReportFields& report)
{
  std::string text;
  for (const LeftOutEntry& entry : LeftOutEntries(report))
  {
    text += (entry.IsCovered ? " Left out, but within the bound: " : " Not proved: ") +
      entry.Sentence + ".";
  }
  return text;
}

std::string ReferenceText(const ReportFields& report)
{
  const std::optional<double> triangles = report.Number("reference.triangles");
  return triangles ? " The original is the reference of " + GroupedText(*triangles) +
      " triangles here, of which the input is a result."
                   : std::string();
}

/// Beside the bound.
std::string HeadlineWord(const ReportFields& report)
{
  const std::string status = report.Text("proof.status");
  return status == "proved" ? "proved"
    : status == "violated"  ? "proved, but farther than requested"
                            : "proved, but perhaps farther than requested";
}

/// What the bound does not cover.
std::string ExceptionsText(const ReportFields& report)
{
  const std::string boundaries = report.Text("proof.boundaries");
  const bool areCovered = boundaries == "neither" || boundaries == "both";
  std::string exceptions = areCovered ? "" : "open boundaries";
  for (const LeftOutEntry& entry : LeftOutEntries(report))
  {
    exceptions += entry.IsCovered ? "" : (exceptions.empty() ? "" : "; ") + entry.Sentence;
  }
  return (boundaries == "both" ? " Open boundaries are as close to each other." : "") +
    (exceptions.empty() ? "" : " <a href=\"#proved\">Exceptions</a>: " + exceptions + ".");
}

std::string BoundsTable(const ReportFields& report)
{
  std::vector<std::vector<std::string>> rows = { { "largest distance, mm", "at least",
    "at most" } };
  const std::pair<const char*, const char*> lines[] = { { "proof.", "both directions" },
    { "proof.output_to_input.", "simplified to original" },
    { "proof.input_to_output.", "original to simplified" },
    { "proof.boundary_output_to_input.", "open boundaries, simplified to original" },
    { "proof.boundary_input_to_output.", "open boundaries, original to simplified" } };
  for (const auto& [path, title] : lines)
  {
    const std::optional<double> lower = report.Number(path + std::string("lower"));
    const std::optional<double> upper = report.Number(path + std::string("upper"));
    if (lower || upper)
    {
      rows.push_back({ title, lower ? LowerBoundText(*lower, Decimals) : "not known",
        upper ? UpperBoundText(*upper, Decimals) : "no bound" });
    }
  }
  return Table(rows);
}
}

std::string ReasonWithoutProof(const ReportFields& report)
{
  const std::string error = report.Text("options.MaximumError");
  const std::string preset = report.Text("options.ErrorPreset");
  const bool hasError = (!error.empty() && error != "0") || (!preset.empty() && preset != "None") ||
    !report.Text("options.ToleranceArrayName").empty();
  const bool hasBound = hasError || report.Number("smoothing.bound").value_or(0.0) > 0.0;
  return hasBound && report.Text("options.ProveResult") != "on" ? "the proof was switched off"
    : hasError ? "mode " + report.Text("options.Mode") + " proves no largest error"
               : "no largest error was requested";
}

//------------------------------------------------------------------------------
std::string ErrorHeadline(const ReportFields& report)
{
  const std::optional<std::string> upper = ProvedText(report);
  if (upper)
  {
    return PageBlock("proved headline",
      { { "upper", *upper }, { "word", HeadlineWord(report) },
        { "tolerance", ToleranceText(report) }, { "exceptions", ExceptionsText(report) } });
  }
  const std::optional<double> there = report.Number("distance.input_to_output.max");
  const std::optional<double> back = report.Number("distance.output_to_input.max");
  return there && back ? PageBlock("measured headline",
                           { { "largest", EscapedXml(MeasuredText(std::max(*there, *back))) },
                             { "reason", ReasonText(report) } })
                       : PageBlock("no headline", { { "reason", ReasonText(report) } });
}

std::string ProofSection(const ReportFields& report)
{
  if (report.Text("proof.status").empty())
  {
    return PageBlock("no proof", { { "reason", ReasonText(report) } });
  }
  return PageBlock("proof",
    { { "tolerance", ToleranceText(report) }, { "status", StatusText(report) },
      { "boundaries", BoundariesText(report.Text("proof.boundaries")) },
      { "left out", LeftOutText(report) }, { "reference", ReferenceText(report) },
      { "table", BoundsTable(report) } });
}

std::string ProofClause(const ReportFields& report)
{
  const std::optional<std::string> upper = ProvedText(report);
  return upper ? ", but no farther than the proved " + *upper + " mm" : std::string();
}

std::string LevelsProof(const ReportFields& report)
{
  if (report.Text("stop_reason").empty() || report.Text("stop_reason") == "not_run")
  {
    return PageBlock("levels of a log");
  }
  const std::optional<std::string> upper = ProvedText(report);
  return upper && report.Text("proof.status") == "proved"
    ? PageBlock("levels proof",
        { { "tolerance", ToleranceText(report) }, { "upper", *upper },
          { "boundaries", BoundariesText(report.Text("proof.boundaries")) },
          { "left out", LeftOutText(report) }, { "reference", ReferenceText(report) } })
    : PageBlock("levels without proof", { { "reason", ReasonText(report) } });
}
}
