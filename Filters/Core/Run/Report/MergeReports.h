// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MergeReports.h
 * @brief The report on a surface that was simplified in parts, from those on its parts.
 */
#ifndef BoneDecimate_Core_Run_Report_MergeReports_h
#define BoneDecimate_Core_Run_Report_MergeReports_h

#include "Report.h"

namespace bonedecimate
{
/**
 * Adds what adds up over parts of any partition: edits, seconds of the stages, what was left out,
 * and the checksum of the result; the running error is the largest. All other figures depend on how
 * the parts meet, and each partition adds them itself.
 */
void AddPart(const Report& part, Report& whole);
}

#endif
