// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportCells.h
 * @brief Replaces the triangle ids in a report by the ids of the input cells from which the
 * triangles came.
 */
#ifndef BoneDecimate_Core_Run_Report_ReportCells_h
#define BoneDecimate_Core_Run_Report_ReportCells_h

#include "Report.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace bonedecimate
{
/// Several triangles may belong to the same cell.
/// @param cellOf For each triangle its cell.
template <typename CellOf>
void NameCells(const CellOf& cellOf, Diagnostic& finding)
{
  if (InfoOf(finding.Kind).IdKind != "triangle")
  {
    return;
  }
  std::vector<Index>& ids = finding.First;
  std::transform(ids.begin(), ids.end(), ids.begin(),
    [&](Index id) { return static_cast<Index>(cellOf(static_cast<std::size_t>(id))); });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

template <typename CellOf>
void NameCells(const CellOf& cellOf, Report& report)
{
  CleaningStatistics& found = report.Cleaning;
  for (std::int64_t* triangle : { &found.FirstTriangleOutOfRange, &found.FirstDroppedTriangle })
  {
    *triangle = *triangle < 0 ? -1 : cellOf(static_cast<std::size_t>(*triangle));
  }
  for (LeftOut& entry : report.LeftOut)
  {
    entry.FirstTriangle =
      entry.FirstTriangle < 0 ? -1 : cellOf(static_cast<std::size_t>(entry.FirstTriangle));
  }
  for (Diagnostic& finding : report.Diagnostics)
  {
    NameCells(cellOf, finding);
  }
}
}

#endif
