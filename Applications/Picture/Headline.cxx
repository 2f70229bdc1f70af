// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Headline.h"

#include "Base/Text.h"
#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"
#include "ProofSection.h"
#include "SurfaceDistances.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
std::string CountIn(const ReportFields& report, const char* name)
{
  const std::optional<double> value = report.Number(name);
  return value ? GroupedText(*value) : "not known";
}

std::string TypicalTile(const ReportFields& report, const std::vector<double>& sorted)
{
  const std::optional<double> there = report.Number("distance.input_to_output.mean");
  const std::optional<double> back = report.Number("distance.output_to_input.mean");
  if (!there || !back)
  {
    return {};
  }
  return FigureTile(EscapedXml(MeasuredText(std::max(*there, *back))) + " mm",
    "apart on average" +
      (sorted.empty() ? std::string()
                      : "; 95 % of the points of the original within " +
            EscapedXml(MeasuredText(Quantile(sorted, 0.95))) + " mm"));
}

std::string TrianglesTile(const ReportFields& report)
{
  const std::optional<double> before = CountBeforePruning(report, "triangles");
  const std::optional<double> after = report.Number("output.triangles");
  const std::string ratio = before && after && *before > 0.0
    ? GroupedText(100.0 * *after / *before, 1) + " % of "
    : std::string("instead of ");
  return FigureTile(CountIn(report, "output.triangles"),
    "triangles, " + ratio + (before ? GroupedText(*before) : "not known"));
}

std::string SpeckClause(const SpeckFigures& specks)
{
  return specks.Specks == 0 ? std::string()
                            : "; " + GroupedText(static_cast<double>(specks.Specks)) +
      (specks.Specks == 1 ? " is a speck" : " are specks") + ", smaller than " +
      ShortText(specks.Size) + " mm";
}

std::string ComponentsTile(const ReportFields& report, const SpeckFigures& specks)
{
  const std::optional<double> before = CountBeforePruning(report, "components");
  const double pruned = report.Number("pruned.components").value_or(0.0);
  return FigureTile(
    CountIn(report, "output.components") + " of " + (before ? GroupedText(*before) : "not known"),
    "components (separate pieces) kept" +
      (pruned > 0.0 ? ", " + GroupedText(pruned) + " pruned on request" : SpeckClause(specks)),
    before > report.Number("output.components"));
}

std::int64_t NotEmpty(const std::vector<LabelExtent>& labels)
{
  return std::count_if(
    labels.begin(), labels.end(), [](const LabelExtent& label) { return label.Triangles > 0; });
}

std::string LabelsTile(const ReportFields& report, const PageLabels& labels)
{
  const double changed = report.Number("voxels.changed").value_or(0.0);
  const std::int64_t before = NotEmpty(labels.Before);
  const std::int64_t after = NotEmpty(labels.After);
  return FigureTile(std::to_string(after) + " of " + std::to_string(before),
    "labels in the input kept" +
      (changed > 0.0 ? "; " + GroupedText(changed) + " voxels have another label" : std::string()),
    after < before);
}

std::string Change(double before, double after)
{
  return SizeText(before) + " &rarr; " + SizeText(after);
}
}

PageLabels PageLabelsOf(vtkPolyData* before, vtkPolyData* result)
{
  if (!before || !result)
  {
    return {};
  }
  const std::vector<NamedLabel> labels = LabelsOf(result);
  return { LabelExtents(before, labels), LabelExtents(result, labels) };
}

std::string HeadlineSection(const ReportFields& report, const std::vector<double>& sorted,
  const PageLabels& labels, const SpeckFigures& specks)
{
  return PageBlock("headline",
    { { "headline", ErrorHeadline(report) }, { "typical", TypicalTile(report, sorted) },
      { "triangles", TrianglesTile(report) },
      { "kept",
        labels.Before.empty() ? ComponentsTile(report, specks) : LabelsTile(report, labels) } });
}

std::string SpeckHint(const SpeckFigures& specks)
{
  const auto count = [](std::int64_t number) { return GroupedText(static_cast<double>(number)); };
  return specks.AreMany()
    ? PageBlock("specks",
        { { "specks", count(specks.Specks) }, { "components", count(specks.Components) },
          { "size", ShortText(specks.Size) }, { "area", SizeText(100.0 * specks.AreaRatio) } })
    : std::string();
}

std::string LabelSection(const PageLabels& labels)
{
  std::vector<std::vector<std::string>> rows = { { "label", "components before", "after",
    "volume, mm&sup3;", "area, mm&sup2;", "triangles after" } };
  for (std::size_t i = 0; i < labels.Before.size(); ++i)
  {
    const LabelExtent& before = labels.Before[i];
    const LabelExtent& after = labels.After[i];
    const auto count = [](std::int64_t number) { return GroupedText(static_cast<double>(number)); };
    rows.push_back({ EscapedXml(LabelText(before.Label)), count(before.Components),
      count(after.Components), Change(before.Volume, after.Volume), Change(before.Area, after.Area),
      count(after.Triangles) });
  }
  return rows.size() == 1 ? std::string() : PageBlock("labels", { { "table", Table(rows) } });
}
}
