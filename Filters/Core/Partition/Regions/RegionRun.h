// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegionRun.h
 * @brief A run in which most of the surface may not change reads the rest of it only near what may
 * change.
 *
 *     prepared = RegionCache::Whole(input)     cleaned, counted; once for each surface
 *     regions  = FindRegions(tolerances)       triangles without a corner of tolerance 0
 *     part     = CutRegion(region)             with its surroundings
 *     result   = the ordinary run of the part, proof included
 *     joined   = JoinRegions(results)          into the unchanged rest
 *     CheckJoined(input, joined)               by coordinates
 *
 * Documentation/explanation/partition.md says when, and why the proof holds.
 */
#ifndef BoneDecimate_Core_Partition_Regions_RegionRun_h
#define BoneDecimate_Core_Partition_Regions_RegionRun_h

#include "Base/Monitor.h"
#include "Options/Options.h"
#include "Run/Input/RunInputs.h"
#include "Run/Output/Result.h"

namespace bonedecimate
{
/// A run that reads the whole surface.
using WholeRun = Result (*)(const Surface&, const Options&, const Monitor&, const RunInputs&);

/// Runs the regions alone if most of the surface may not change, and otherwise, or if that fails,
/// the whole; the report says which.
/// @param options Must be valid.  @param run Simplifies a part, or the whole.
Result DecimateRegions(const Surface& input, const Options& options, const Monitor& monitor,
  const RunInputs& inputs, WholeRun run);
}

#endif
