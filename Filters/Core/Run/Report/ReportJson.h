// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportJson.h
 * @brief A list of entries as JSON: the same text for the program, the filters and Python.
 */
#ifndef BoneDecimate_Core_Run_Report_ReportJson_h
#define BoneDecimate_Core_Run_Report_ReportJson_h

#include "ReportTable.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * Entries nested at the dots of their names, "input.triangles" as {"input": {"triangles": ...}};
 * where the names are 0, 1, ... the values are a list. "units" has the unit of each entry that has
 * one, by its whole name. Numbers read back the same; those that are not finite are null. Bytes of
 * texts that are not UTF-8 become U+FFFD.
 */
std::string ReportJson(const std::vector<ReportEntry>& entries);
}

#endif
