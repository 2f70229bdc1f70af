// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportTable.h
 * @brief The report as a flat list of named values: one list for JSON, field data and getters.
 */
#ifndef BoneDecimate_Core_ReportTable_h
#define BoneDecimate_Core_ReportTable_h

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
 * All entries of a report, always in the same order. Entries of distances, of the reference, of the voxels and of the
 * proof are left out when there are none, those of borders, of the clearance between fragments and of labels where there
 * are none.
 *
 *     version, stop_reason, stop_sentence
 *     input    .{faces, points, components, boundary_edges, non_manifold_edges, euler_number, area, volume}
 *              .{faces_read, points_read, merged_points, unused_points, dropped_triangles, first_dropped_triangle,
 *                locked_points, first_locked_point, frozen_points, checksum, problem}
 *     findings .N.{kind, severity, sentence, count, length}, with ExamineInput
 *              .N.{first_points, first_triangles}.K
 *     pruned   .{components, faces}, if pruning was asked for
 *              .list.N.{faces, size, area, volume, place.{0, 1, 2}} of the thousand largest
 *     output   .{faces ... volume}
 *     distance .{output_to_input, input_to_output}
 *                .{max, second, mean, rms, point_max, point_mean, point_rms, samples, samples_per_mm2}
 *              .{border_output_to_input, border_input_to_output}.{lower, upper}
 *     voxel    .{from, size, error, largest_error}
 *     reference.{faces, checksum, to_input.{lower, upper}}
 *     proof    .{verdict, tolerance, lower, upper, borders, triangles_left_out}
 *              .{output_to_input, input_to_output, border_...}.{lower, upper}
 *     clearance.{input, output}
 *     labels   .{count, largest_change}
 *              .of_LABEL.{input_area, output_area}
 *     running_error, normal_tolerance, collapses, refusals.{non_manifold, border, ...}
 *     seconds  .{prepare, collapse, decimate, measure, prove, total}
 *     options  .{each option by name}
 */
std::vector<ReportEntry> ReportEntries(const Report& report);
}

#endif
