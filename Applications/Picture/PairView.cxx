// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PairView.h"

#include "Base/Text.h"
#include "NumberText.h"
#include "PageParts.h"
#include "PageTemplate.h"
#include "ReportFields.h"
#include "SurfaceDistances.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
bool HasTriangles(vtkPolyData* surface)
{
  return surface && TrianglesOnly(surface)->GetNumberOfPolys() > 0;
}

LargestDistance LargestOf(
  const PairSubject& subject, std::size_t side, const std::string& direction)
{
  if (subject.Largest)
  {
    return (*subject.Largest)[side];
  }
  const ReportFields report(subject.Result);
  const std::string path = "distance." + direction;
  LargestDistance largest = { report.Number(path + ".max").value_or(0.0), {} };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto at = report.Number(path + ".max_at." + std::to_string(axis));
    largest.Position[axis] = at.value_or(0.0);
    largest.Distance = at ? largest.Distance : 0.0;
  }
  return largest;
}
}

ViewerHtml PairViewer(
  const PairSubject& subject, const std::vector<FarPoint>& points, std::size_t bytesOfPicture)
{
  if (!HasViewer() || !HasTriangles(subject.Before) || !HasTriangles(subject.Result))
  {
    return {};
  }
  ViewerSubject viewer;
  viewer.Before = { subject.Before, subject.DistanceArrayName, "" };
  viewer.Levels = { { subject.Result, subject.ResultDistanceArrayName, "" } };
  viewer.Reduce = subject.Reduce;
  viewer.Frame = subject.Frame;
  viewer.Tolerance = subject.Tolerance;
  viewer.Names = subject.Names;
  viewer.Farthest = points;
  viewer.MostBytes = BytesOfViewer(bytesOfPicture);
  return ComposeViewer(viewer);
}

//------------------------------------------------------------------------------
std::vector<FarPoint> FarthestOfPair(const PairSubject& subject)
{
  return subject.Before && subject.Result
    ? FindFarthestPoints(
        { subject.Before, subject.DistanceArrayName, LargestOf(subject, 0, "input_to_output") },
        { subject.Result, subject.ResultDistanceArrayName,
          LargestOf(subject, 1, "output_to_input") })
    : std::vector<FarPoint>();
}

//------------------------------------------------------------------------------
std::string WhereSection(const std::vector<FarPoint>& points, const std::string& frame,
  const std::array<std::string, 2>& surfaces)
{
  const bool hasLabels = std::any_of(
    points.begin(), points.end(), [](const FarPoint& one) { return !one.Labels.empty(); });
  std::vector<std::vector<std::string>> rows = { { "", "distance, mm", "position, mm",
    "point of the surface" } };
  if (hasLabels)
  {
    rows[0].push_back("label");
  }
  for (const FarPoint& one : points)
  {
    rows.push_back({ std::to_string(rows.size()), EscapedXml(MeasuredText(one.Distance)),
      AnatomicalText(one.Position, frame), one.IsOnOriginal ? surfaces[0] : surfaces[1] });
    if (hasLabels)
    {
      std::string labels;
      for (const std::string& label : one.Labels)
      {
        labels += (labels.empty() ? "" : ", ") + EscapedXml(label);
      }
      rows.back().push_back(labels);
    }
  }
  return points.empty() ? std::string()
                        : PageBlock("where",
                            { { "table", Table(rows) },
                              { "frame", PageBlock(frame.empty() ? "axes" : "patient axes") } });
}
}
