// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CertificateTable.h
 * @brief A certificate as a flat list of named values, as ReportTable.h is of a report.
 */
#ifndef BoneDecimate_Core_CertificateTable_h
#define BoneDecimate_Core_CertificateTable_h

#include "Certificate/Certificate.h"
#include "ReportTable.h"

#include <vector>

namespace bonedecimate
{
/**
 * All entries, always in the same order: version, problem, verdict, lower, upper, slack, borders, seconds; then for each
 * of reference_to_result, result_to_reference and, if a surface has borders, border_reference_to_result and
 * border_result_to_reference: .verdict, .lower, .upper, .x, .y, .z, .triangle, .nearest_triangle, .cuts; with a map
 * .excess.{lower, upper, x, y, z, triangle, nearest_triangle, cuts}; with means .mean, .mean_error, .rms, .rms_error,
 * .area, .samples. A certificate with a problem has the first three alone.
 */
std::vector<ReportEntry> CertificateEntries(const Certificate& certificate);

/// One word: "both".
const char* BorderPresenceWord(BorderPresence presence);
}

#endif
