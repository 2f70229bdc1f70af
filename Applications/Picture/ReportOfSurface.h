// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportOfSurface.h
 * @brief The report that travels with a surface in its field data. What it proves, it proves of one
 * surface: that whose triangles have the report's checksum, to the bit and in any order.
 */
#ifndef BoneDecimate_Applications_ReportOfSurface_h
#define BoneDecimate_Applications_ReportOfSurface_h

#include <nlohmann/json_fwd.hpp>

class vtkPolyData;

namespace bonedecimate
{
/// An empty object if there is none. For another surface than the proved one, the proof is a
/// sentence that says so.
nlohmann::ordered_json ReportOf(vtkPolyData* surface);

/// Replaces the report; what it proves holds for this surface from now on. Field data that it has
/// in common with another surface are copied before.
void SetReportOf(nlohmann::ordered_json report, vtkPolyData* surface);

/// Composes the sentences of what is proved and left out again, after numbers of a report were
/// changed.
void UpdateSentences(nlohmann::ordered_json& report);
}

#endif
