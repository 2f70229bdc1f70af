// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TunnelRun.h
 * @brief A run of a surface whose narrow tunnels are closed first.
 *
 *     closed = CloseTunnels(input)       plugs in place of bands of triangles; nothing else changes
 *     result = run(closed)                errors, distances and proof refer to the closed surface
 *     origins of the result               as ids of the input; on plugs the nearest ones
 *
 * Documentation/tunnels.md says what this means for the error.
 */
#ifndef BoneDecimate_Core_Run_TunnelRun_h
#define BoneDecimate_Core_Run_TunnelRun_h

#include "Partition/Regions/RegionRun.h"

namespace bonedecimate
{
/**
 * Without a TunnelSize this is run(input). If the run has something that tunnels cannot be closed
 * with (RunKinds.h), nothing is run and the input is rejected.
 * @param options Must be valid.  @param run Gets options without tunnels to close.
 */
Result CloseTunnelsThenRun(const Surface& input, const Options& options, const Monitor& monitor,
  const RunInputs& inputs, const WholeRun& run);
}

#endif
