// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportTable.h
 * @brief The report as a flat list of named values: one list for JSON, field data and getters.
 */
#ifndef BoneDecimate_Core_Run_Report_ReportTable_h
#define BoneDecimate_Core_Run_Report_ReportTable_h

#include "Report.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace bonedecimate
{
using ReportValue = std::variant<std::int64_t, double, std::string>;

struct ReportEntry
{
  std::string Name; ///< Path with dots, "distance.output_to_input.max".
  std::string Unit; ///< "mm", "mm2", "mm3", "s" or empty.
  ReportValue Value;
};

/**
 * All entries of a report, always in the same order. Entries of distances, reference, voxels,
 * proof, boundaries, the gap between fragments and labels are omitted if there are none.
 *
 *     version, stop_reason, stop_sentence
 *     input    .{faces, points, components, boundary_edges, non_manifold_edges, euler_number, area,
 *                volume}
 *              .{faces_read, points_read, merged_points, unused_points, dropped_triangles,
 *                first_dropped_triangle, non_manifold_points, first_non_manifold_point,
 *                constrained_points, checksum, problem}
 *     diagnostics .N.{kind, severity, sentence, count, length}, with DiagnoseInput
 *              .N.{first_points, first_triangles}.K
 *     pruned   .{components, faces}, if pruning was requested
 *              .list.N.{faces, size, area, volume, center.{0, 1, 2}} of the thousand largest
 *     weld     .{points, movement}, with WeldDistance
 *     output   .{faces ... volume, checksum}
 *     distance .{output_to_input, input_to_output}
 *                .{max, max_at.{0, 1, 2}, second, mean, rms, point_max, point_mean, point_rms,
 *                  samples, samples_per_mm2}
 *              .{boundary_output_to_input, boundary_input_to_output}.{lower, upper}
 *     voxel    .{from, size, error, largest_error}
 *     smoothing.{surface, bound, ..., rounds}
 *     parts    .{kind, count, smallest_volume}, if the surface was smoothed
 *              .list.N.{label, triangles, center.{0, 1, 2}} of the largest
 *              .list.N.{input, output}.{area, volume, thickness_median, thickness_percentile_5}
 *     voxels   .{guard, compared, changed, first_changed.{0, 1, 2}}, if the input has a voxel grid
 *              .of_LABEL.{voxels, lost, gained}
 *     reference.{faces, checksum, to_input.{lower, upper}}
 *     left_out .N.{kind, count, what, where, distance, sentence}
 *     proof    .{status, tolerance, lower, upper, boundaries, sentence}
 *              .{output_to_input, input_to_output, boundary_...}.{lower, upper}
 *     fragment_gap.{input, output}
 *     labels   .{count, largest_change}
 *              .of_LABEL.{input_area, output_area}
 *     running_error, normal_tolerance, collapses, rejections.{non_manifold, boundary, ...}
 *     seconds  .{prepare, collapse, decimate, measure, prove, total}
 *     options  .{each option by name}
 */
std::vector<ReportEntry> ReportEntries(const Report& report);
}

#endif
