// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ListLeftOut.h
 * @brief Lists what of an input is not in the surface that is proved, with its distance from the
 * result.
 *
 *     triangles     that cleaning dropped, because they have no area
 *     components    that were pruned
 *     and what readers and filters left out before (RunInputs::LeftOut)
 *
 * With a reference the proof refers to that surface, and so does the list.
 */
#ifndef BoneDecimate_Core_Run_Output_ListLeftOut_h
#define BoneDecimate_Core_Run_Output_ListLeftOut_h

#include "Mesh/Cleaning.h"
#include "Result.h"
#include "Run/Input/ReferenceInput.h"
#include "Run/Input/RunInputs.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Fills in the list in the report; with distances if a proof was made.
/// @param cleaned Its counts and its list of kept input triangles are used.
/// @param reference Null: the input.
void ListLeftOut(const Surface& input, const CleanSurface& cleaned, const KeptSurface* reference,
  const RunInputs& inputs, Result& result);

/// An entry for each shape, with its distance from the surface.
std::vector<LeftOut> DistancesOf(
  std::vector<LeftOutShape> all, const Surface& surface, int threads);

/// What was left out of two surfaces that are compared, each with its distance from the other
/// surface.
std::vector<LeftOut> LeftOutOfPair(const std::vector<LeftOutShape>& ofReference,
  const Surface& reference, const std::vector<LeftOutShape>& ofResult, const Surface& result,
  int threads);

/// Puts the shapes into the report; with distances if a proof was made.
void MeasureLeftOut(std::vector<LeftOutShape> all, Result& result);

/// @param first The number of the first one; negative: not known.
LeftOutShape TrianglesWithoutArea(
  std::int64_t count, std::int64_t first, std::vector<std::array<Vector3, 3>> shapes);

/// The positions of those triangles that have an area, or of those that have none.
std::vector<std::array<Vector3, 3>> ShapesOf(
  const std::vector<Vector3>& points, const std::vector<Triangle>& triangles, bool withoutArea);

/// mm, no point of the shapes is farther from the surface; not a number without shapes or without a
/// surface.
double MaxDistance(
  const std::vector<std::array<Vector3, 3>>& shapes, const Surface& surface, int threads);
}

#endif
