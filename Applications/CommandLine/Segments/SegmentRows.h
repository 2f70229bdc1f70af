// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentRows.h
 * @brief The segments of a report as rows of a table: what each was and what became of it.
 */
#ifndef BoneDecimate_Applications_SegmentRows_h
#define BoneDecimate_Applications_SegmentRows_h

#include <nlohmann/json.hpp>
#include <vector>

namespace bonedecimate
{
/// Columns of segments.csv behind the name of the input.
inline constexpr const char* SegmentColumns[] = { "label", "segment", "triangles", "components",
  "area_in_mm2", "area_out_mm2", "volume_in_mm3", "volume_out_mm3", "thickness_in_mm",
  "thickness_out_mm", "thickness_percentile_5_in_mm", "thickness_percentile_5_out_mm", "voxels",
  "voxels_lost", "voxels_gained" };

/// Figures by column; what the report does not have is null. Areas and thickness are there if
/// the run smoothed, of the largest segments.
std::vector<nlohmann::json> SegmentRows(const nlohmann::json& report);
}

#endif
