// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportEntries.h
 * @brief What the parts of the report's table have in common.
 */
#ifndef BoneDecimate_Core_Run_Report_ReportEntries_h
#define BoneDecimate_Core_Run_Report_ReportEntries_h

#include "Figures/LeftOut.h"
#include "Figures/SurfaceFigures.h"
#include "ReportTable.h"

#include <cmath>
#include <string>
#include <vector>

namespace bonedecimate
{
using Entries = std::vector<ReportEntry>;

/// None if it is not a number.
inline void AddIfKnown(
  Entries& entries, const std::string& name, const std::string& unit, double value)
{
  if (!std::isnan(value))
  {
    entries.push_back({ name, unit, value });
  }
}

/// Numbered below the path.
void AddLeftOut(Entries& entries, const std::string& path, const std::vector<LeftOut>& leftOut);

/// Counts, area and volume of a surface.
void AddCounts(Entries& entries, const std::string& path, const SurfaceStatistics& surface);

/// mm
inline void AddPosition(Entries& entries, const std::string& path, const Vector3& position)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    entries.push_back({ path + "." + std::to_string(axis), "mm", position[axis] });
  }
}
}

#endif
