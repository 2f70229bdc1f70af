// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceInput.h
 * @brief For an input that is itself a result, computes how much of the largest error relative to
 * the first original (the reference) remains at each point.
 *
 *     Certify(reference, input)             an upper bound b of the distance of
 *                                           each triangle, in both directions
 *     used(t) = max of b(t) and of b(r) over all r with a point to which t may be nearest
 *                                           (within b(r) of r)
 *     left(p) = largest error - max of used(t) over the triangles t at p, but at least 0
 *
 * A run that keeps these tolerances relative to its input keeps the largest error relative to
 * the reference: a point of the reference is at most used(t) from its nearest point of the
 * input, which is at most left from the result, linear on t; a point of the result is at most
 * left from a triangle t, which is at most b(t) from the reference. Boundaries are treated in
 * the same way, with one bound for all. Documentation/explanation/partition.md gives the proof.
 * Where nothing is left the input is constrained.
 */
#ifndef BoneDecimate_Core_Run_Input_ReferenceInput_h
#define BoneDecimate_Core_Run_Input_ReferenceInput_h

#include "Base/Monitor.h"
#include "Figures/InputFigures.h"
#include "Figures/InputStatus.h"
#include "Figures/LeftOut.h"
#include "Mesh/Cleaning.h"
#include "Options/Options.h"

#include <vector>

namespace bonedecimate
{
/// The stored surface without the triangles that cleaning dropped.
struct KeptSurface
{
  bonedecimate::Surface Surface;
  std::vector<Triangle> LeftOut; ///< The dropped triangles, and those of pruned components.
};

/// All points and the triangles that cleaning kept, in the order of the input.
KeptSurface KeptPart(const Surface& input, const CleanSurface& cleaned);

struct ReferenceInput
{
  InputStatus Status = InputStatus::Good;
  KeptSurface Reference;
  ReferenceFigures Figures;
  /// mm, for each point of the input; the largest error at points without a triangle.
  std::vector<double> Left;
};

/// @param cleaned The cleaned input. @param options With the largest error.
ReferenceInput CompareWithReference(const Surface& reference, const Surface& input,
  const CleanSurface& cleaned, const Options& options, const Monitor& monitor);
}

#endif
