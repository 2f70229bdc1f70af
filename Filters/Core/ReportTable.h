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
 * All entries of a report, always in the same order. Entries of distances are left out when none were measured, those of
 * borders and of the clearance between fragments where there are none.
 * Names: version, stop_reason, stop_sentence, input.{faces, points, components, boundary_edges,
 * non_manifold_edges, euler_number, area, volume, faces_read, points_read, merged_points, unused_points,
 * dropped_triangles, first_dropped_triangle, locked_points, first_locked_point, checksum, problem}, output.{faces ... volume}, distance.output_to_input.{max, second,
 * mean, rms, point_max, point_mean, point_rms, samples, samples_per_mm2}, distance.input_to_output.{the same},
 * distance.border_output_to_input.{lower, upper}, distance.border_input_to_output.{the same},
 * findings.N.{kind, severity, sentence, count, length, first_points.K or first_triangles.K} with ExamineInput;
 * pruned.{components, faces}, pruned.list.N.{faces, size, area, volume, place.{0, 1, 2}} of the thousand largest, if pruning
 * was asked for; clearance.{input, output}, running_error, collapses, refusals.{non_manifold, border, ...}, seconds.{prepare, collapse, decimate, measure,
 * total}, options.{each option by name}.
 */
std::vector<ReportEntry> ReportEntries(const Report& report);
}

#endif
