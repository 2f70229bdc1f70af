// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WeldOperation.h
 * @brief Welds open boundaries before a run.
 *
 *     welded = Weld(input)         no point moves by more than m <= WeldDistance (Run/Input/Weld.h)
 *     result = run(welded)           with the largest error and all tolerances smaller by m
 *     bounds of the report   larger by m, so that they hold between result and input as it was read
 *
 * Points with the same barycentric coordinates in the same triangle of input and welded surface are
 * at most m apart, so the distance to one of the two surfaces is at most m more than that to the
 * other. Open boundaries are compared with those that are left after welding, which are at most m
 * away from the same edges of the input. Measured distances refer to the welded surface.
 */
#ifndef BoneDecimate_Core_Run_WeldOperation_h
#define BoneDecimate_Core_Run_WeldOperation_h

#include "InputOperation.h"

#include <memory>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Rejects a request whose points would move by more than half of the largest error.
std::unique_ptr<InputOperation> MakeWeldOperation();

/// What welding did, a sentence; none if it did not run.
std::vector<std::string> WeldSentences(const WeldFigures& figures);
}

#endif
