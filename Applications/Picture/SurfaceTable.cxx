// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTable.h"

#include "NumberText.h"
#include "PageParts.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
namespace
{
const std::string NoValue = "not known";

/// "12, 340, 2,020": how many triangles have an angle below 10, 20 and 30 degrees.
std::string SmallAngles(const ReportFields& report, const std::string& side)
{
  std::string counts;
  double below = 0.0;
  for (const char* bin : { "0", "1", "2" })
  {
    const std::optional<double> count = report.Number(side + "shape.smallest_angles." + bin);
    if (!count)
    {
      return NoValue;
    }
    below += *count;
    counts += (counts.empty() ? "" : "; ") + GroupedText(below);
  }
  return counts;
}
}

std::string SurfaceTable(const ReportFields& report, const std::array<std::string, 2>& sides,
  const std::array<std::string, 2>& titles)
{
  std::vector<std::vector<std::string>> rows = { { "", titles[0], titles[1] } };
  struct Line
  {
    const char* Title;
    const char* Name;
    int Decimals;
  };
  const Line lines[] = { { "Triangles", "triangles", 0 }, { "Points", "points", 0 },
    { "Components (separate pieces)", "components", 0 }, { "Boundary edges", "boundary_edges", 0 },
    { "Edges of three or more triangles", "non_manifold_edges", 0 },
    { "Euler number", "euler_number", 0 },
    { "Intersecting pairs of triangles", "intersecting_pairs", 0 }, { "Area, mm&sup2;", "area", 1 },
    { "Volume, mm&sup3;", "volume", 1 },
    { "Smallest angle of the triangles, degrees", "shape.smallest_angle", 1 },
    { "Largest angle, degrees", "shape.largest_angle", 1 },
    { "Mean radius ratio (1 is equilateral)", "shape.mean_radius_ratio", 2 },
    { "Mean aspect ratio (1 is equilateral)", "shape.mean_aspect_ratio", 2 } };
  for (const Line& line : lines)
  {
    std::vector<std::string> row = { line.Title };
    bool isKnown = false;
    for (const std::string& side : sides)
    {
      const std::optional<double> value = report.Number(side + line.Name);
      isKnown = isKnown || value;
      row.push_back(value ? GroupedText(*value, line.Decimals) : NoValue);
    }
    if (isKnown)
    {
      rows.push_back(row);
    }
  }
  const std::array<std::string, 2> angles = { SmallAngles(report, sides[0]),
    SmallAngles(report, sides[1]) };
  if (angles[0] != NoValue || angles[1] != NoValue)
  {
    rows.push_back({ "Triangles with an angle below 10; 20; 30 degrees", angles[0], angles[1] });
  }
  return Table(rows);
}
}
