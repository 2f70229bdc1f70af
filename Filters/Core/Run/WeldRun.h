// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WeldRun.h
 * @brief A run of a surface whose open boundaries are welded first.
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
#ifndef BoneDecimate_Core_Run_WeldRun_h
#define BoneDecimate_Core_Run_WeldRun_h

#include "Partition/Regions/RegionRun.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// Without a WeldDistance this is run(input). If the run has something that does not go with
/// welding (RunKinds.h), or points would move by more than half of the largest error, nothing is
/// run and the input is rejected.
/// @param options Must be valid.  @param run Gets options without a WeldDistance.
Result WeldThenRun(const Surface& input, const Options& options, const Monitor& monitor,
  const RunInputs& inputs, const WholeRun& run);

/// What welding did, a sentence; none if it did not run.
std::vector<std::string> WeldSentences(const WeldFigures& figures);
}

#endif
