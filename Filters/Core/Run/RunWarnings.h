// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunWarnings.h
 * @brief What a run warns of.
 */
#ifndef BoneDecimate_Core_Run_RunWarnings_h
#define BoneDecimate_Core_Run_RunWarnings_h

#include "Geometry/Surface.h"
#include "Run/Report/Report.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// WeldSentences(), InputWarnings() and SurfaceHints(), a sentence each. @param input Before
/// welding and cleaning.
std::vector<std::string> RunWarnings(const Surface& input, const Report& report, int threads = 0);
}

#endif
