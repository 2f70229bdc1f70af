// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FarthestPoints.h"
#include "NumberText.h"
#include "Page.h"
#include "PageParts.h"
#include "PageTemplate.h"
#include "PlainText.h"
#include "ProofSection.h"
#include "ReportFields.h"
#include "SurfaceDistances.h"

#include "Base/Text.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
std::string CountText(vtkPolyData* surface)
{
  return GroupedText(static_cast<double>(TrianglesOnly(surface)->GetNumberOfPolys()));
}

std::string LengthText(double millimeters)
{
  return std::isnan(millimeters) ? "not measured" : EscapedXml(MeasuredText(millimeters));
}

std::string LevelsTable(const std::vector<PageLevel>& levels)
{
  std::vector<std::vector<std::string>> rows = { { "triangles", "largest distance, mm",
    "mean distance, mm" } };
  for (auto level = levels.rbegin(); level != levels.rend(); ++level)
  {
    rows.push_back({ CountText(level->Surface), LengthText(level->MaxDistance),
      LengthText(level->MeanDistance) });
  }
  return Table(rows);
}

ViewerHtml Viewer(const LevelsPageSubject& subject, std::size_t bytesOfPicture)
{
  ViewerSubject viewer;
  viewer.Before = { subject.Before, "", "" };
  for (const PageLevel& level : subject.Levels)
  {
    const std::string caption = std::isnan(level.MaxDistance)
      ? ""
      : ", largest distance " + MeasuredText(level.MaxDistance) + " mm";
    viewer.Levels.push_back({ level.Surface, subject.DistanceArrayName, caption });
  }
  viewer.Farthest = FindFarthestPoints(
    { subject.Before, "" }, { subject.Levels.back().Surface, subject.DistanceArrayName });
  viewer.Legend = "distance to the original, mm";
  viewer.Reduce = subject.Reduce;
  viewer.Frame = subject.Frame;
  viewer.MostBytes = BytesOfViewer(bytesOfPicture);
  return ComposeViewer(viewer);
}
}

std::string ComposeLevelsPage(const LevelsPageSubject& subject)
{
  const std::string name = EscapedXml(PlainText(subject.Name));
  const std::string picture = EmbeddedPicture(subject.PictureFile);
  const ViewerHtml viewer = Viewer(subject, picture.size());
  return PageBlock("levels",
    { { "head", PageBlock("head", { { "title", "Levels of detail: " + name } }) }, { "name", name },
      { "input triangles", CountText(subject.Before) },
      { "triangles", CountText(subject.Levels.front().Surface) }, { "viewer", viewer.Section },
      { "viewer script", viewer.Script }, { "picture", picture },
      { "table", LevelsTable(subject.Levels) },
      { "proof", LevelsProof(ReportFields(subject.Report)) } });
}
}
