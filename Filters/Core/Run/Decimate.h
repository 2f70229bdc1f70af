// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Decimate.h
 * @brief Simplifies a surface; the result comes with its error in millimeters.
 *
 *     welded   = Weld(input)                   on request; bounds of what follows are widened
 *                                              (WeldOperation.h)
 *     closed   = CloseTunnels(welded)          on request; what follows refers to the closed
 *                                              surface (TunnelOperation.h)
 *     prepared = PrepareInput(input)           clean, prune, check the errors, build the
 *                                              half-edge mesh
 *     smoothed = SmoothInput(prepared)         positions within a bound, if smoothing is on; proved
 *                                              by their displacement
 *     editor   = MakeEditor(prepared)          the mesh with all that is kept beside it; proves
 *                                              edits if there is a bound
 *     RunStages(editor)                        the stages of the mode (Modes.h), until a
 *                                              target is reached
 *     SeparatePoints(editor)                   points of a proved result that rounding would merge
 *     result   = ExtractResult(editor)         points, triangles, maps
 *     Evaluate(result)                         statistics, distances in both directions, open
 *                                              boundaries
 *     ProveResult(input, result)               the certificate, if there is a bound
 *
 * H. Brandao, Mesh Simplification and Smoothing for Bone Fragment Models, BSc thesis, Groningen
 * 2018: the loop.
 */
#ifndef BoneDecimate_Core_Run_Decimate_h
#define BoneDecimate_Core_Run_Decimate_h

#include "Base/Monitor.h"
#include "Run/Input/RunInputs.h"
#include "Run/Output/Result.h"

#include <vector>

namespace bonedecimate
{
/**
 * Where most points have a tolerance of 0, only the regions around the others are run
 * (Partition/Regions/RegionRun.h).
 * @param input Points in mm and triangles; nothing is changed. Anything may be wrong with it: see
 *   InputStatus.
 * @throws std::bad_alloc and nothing else.
 */
Result Decimate(const Surface& input, const Options& options, const Monitor& monitor = {},
  const RunInputs& inputs = {});

/// The points of the input as the first edit of Decimate would find them.
struct SmoothedInput
{
  /// mm, of each input point. Those of the input if it was rejected or nothing is smoothed.
  std::vector<Vector3> Points;
  bonedecimate::Report Report; ///< Status, smoothing and parts alone.
};

/// @param inputs As those of Decimate.
SmoothedInput SmoothOnly(const Surface& input, const Options& options, const Monitor& monitor = {},
  const RunInputs& inputs = {});
}

#endif
