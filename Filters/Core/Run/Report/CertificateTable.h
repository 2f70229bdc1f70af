// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CertificateTable.h
 * @brief A certificate as a flat list of named values, like ReportTable.h for a report.
 */
#ifndef BoneDecimate_Core_Run_Report_CertificateTable_h
#define BoneDecimate_Core_Run_Report_CertificateTable_h

#include "Figures/LeftOut.h"
#include "Proof/Certificate/Certificate.h"
#include "ReportTable.h"

#include <vector>

namespace bonedecimate
{
/**
 * All entries, always in the same order: version, problem, status, lower, upper, sentence, slack,
 * boundaries, seconds; left_out, as in a report, of both surfaces; then for each of
 * reference_to_result, result_to_reference and, if a surface has boundaries,
 * boundary_reference_to_result and boundary_result_to_reference: .status, .lower, .upper, .x, .y,
 * .z, .triangle, .nearest_triangle, .cuts; with a map .excess.{lower, upper, x, y, z, triangle,
 * nearest_triangle, cuts}; with means .mean, .mean_error, .rms, .rms_error, .area, .samples. A
 * certificate with a problem has only the first three.
 */
std::vector<ReportEntry> CertificateEntries(
  const Certificate& certificate, const std::vector<LeftOut>& leftOut = {});

/// One word: "both".
const char* BoundaryPresenceWord(BoundaryPresence presence);
}

#endif
