// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeTable.h"

namespace bonedecimate
{
void AddShape(Entries& entries, const std::string& path, const ShapeStatistics& shape)
{
  AddIfKnown(entries, path + ".smallest_angle", "degrees", shape.SmallestAngle);
  AddIfKnown(entries, path + ".largest_angle", "degrees", shape.MaxAngle);
  AddIfKnown(entries, path + ".mean_radius_ratio", "", shape.MeanRadiusRatio);
  AddIfKnown(entries, path + ".largest_radius_ratio", "", shape.MaxRadiusRatio);
  AddIfKnown(entries, path + ".mean_aspect_ratio", "", shape.MeanAspectRatio);
  AddIfKnown(entries, path + ".largest_aspect_ratio", "", shape.MaxAspectRatio);
  for (std::size_t bin = 0; bin < shape.MinAngles.size(); ++bin)
  {
    entries.push_back(
      { path + ".smallest_angles." + std::to_string(bin), "", shape.MinAngles[bin] });
  }
}

//------------------------------------------------------------------------------
void AddShapeLimits(Entries& entries, const Report& report)
{
  if (report.Requested.EffectiveMinimumAngle() > 0.0)
  {
    entries.push_back({ "angles.below_minimum", "", report.Angles.Below });
    if (report.Angles.Below > 0)
    {
      AddPosition(entries, "angles.worst_triangle", report.Angles.Worst);
    }
  }
  if (report.Requested.EffectiveEdgeLength() > 0.0)
  {
    entries.push_back({ "edges.mean_length", "mm", report.Edges.Mean });
    entries.push_back({ "edges.longest", "mm", report.Edges.Longest });
    AddIfKnown(entries, "edges.least_requested", "mm", report.Edges.MinRequested);
    entries.push_back({ "edges.longer", "", report.Edges.Longer });
    entries.push_back({ "edges.shorter", "", report.Edges.Shorter });
    if (report.Edges.Longer > 0)
    {
      AddPosition(entries, "edges.longest_edge", report.Edges.Worst);
    }
  }
}
}
