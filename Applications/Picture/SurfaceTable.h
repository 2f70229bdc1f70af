// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceTable.h
 * @brief Counts, measures and triangle shapes of two surfaces of a report, side by side.
 */
#ifndef BoneDecimate_Applications_SurfaceTable_h
#define BoneDecimate_Applications_SurfaceTable_h

#include "ReportFields.h"

#include <array>
#include <string>

namespace bonedecimate
{
/// What neither of the two has is left out.
/// @param sides Beginnings of the names in the report, "input.". @param titles Of the columns.
std::string SurfaceTable(const ReportFields& report, const std::array<std::string, 2>& sides,
  const std::array<std::string, 2>& titles);
}

#endif
