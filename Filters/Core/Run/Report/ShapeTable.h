// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeTable.h
 * @brief The entries of the report about shapes of triangles.
 */
#ifndef BoneDecimate_Core_Run_Report_ShapeTable_h
#define BoneDecimate_Core_Run_Report_ShapeTable_h

#include "ReportEntries.h"

namespace bonedecimate
{
void AddShape(Entries& entries, const std::string& path, const ShapeStatistics& shape);

/// Only with a least angle or an edge length: what does not keep them.
void AddShapeLimits(Entries& entries, const Report& report);
}

#endif
