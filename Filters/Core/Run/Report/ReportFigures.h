// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportFigures.h
 * @brief The figures of a report that are needed most.
 */
#ifndef BoneDecimate_Core_Run_Report_ReportFigures_h
#define BoneDecimate_Core_Run_Report_ReportFigures_h

#include "Report.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Proved upper bound of the distance, both directions and open boundaries, mm; NaN without a
/// proof.
double ProvedError(const Report& report);

/// Largest distance by samples, both directions, mm; NaN if distances were not measured.
double MeasuredError(const Report& report);

/// Number of rejected edits, for all reasons together.
std::int64_t RejectedEdits(const Report& report);

/// Number of edits that were rejected for the reason of that word; 0 for other words.
std::int64_t RejectedEdits(const Report& report, const std::string& reason);

/// Names of the entries that the output of a filter carries as arrays of their own, too;
/// all others are in the JSON alone.
const std::vector<std::string>& KeyFigures();

/// The same of a certificate.
const std::vector<std::string>& CertificateKeyFigures();
}

#endif
