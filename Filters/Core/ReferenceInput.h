// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceInput.h
 * @brief An input that is itself a result: how much of the largest error each of its points has left, if that is promised
 *        against the first original (the reference).
 *
 *     Certify(reference, input)             an upper bound for each triangle, both ways: of a reference triangle r, b(r)
 *     used(t) = max of b(t) and of b(r) of all r from which some point may have t as its nearest   (within b(r) of r)
 *     left(p) = largest error - max of used(t) over the triangles t at p, 0 if that is negative
 *
 * A run that keeps these tolerances against its input keeps the largest error against the reference: a point of the
 * reference is at most used(t) from its nearest place on the input, that at most left from the result, linear on t; a
 * point of the result at most left from a triangle t, and that at most b(t) from the reference. Borders the same, with
 * one bound for all. Documentation/tolerance.md has the proof. Where nothing is left the input is frozen.
 */
#ifndef BoneDecimate_Core_ReferenceInput_h
#define BoneDecimate_Core_ReferenceInput_h

#include "Mesh/Cleaning.h"
#include "Monitor.h"
#include "Options.h"
#include "Report.h"

#include <vector>

namespace bonedecimate
{
/// A surface as it is stored, without the triangles that cleaning dropped.
struct KeptSurface
{
  bonedecimate::Surface Surface;
  std::int64_t LeftOut = 0;
};

/// All points, and the triangles that cleaning kept, in the order of the input.
KeptSurface KeptPart(const Surface& input, const CleanSurface& cleaned);

struct ReferenceInput
{
  InputStatus Status = InputStatus::Good;
  KeptSurface Reference;
  ReferenceFigures Figures;
  std::vector<double>
    Left; ///< mm, of each point of the input; the largest error where no triangle is.
};

/// @param cleaned Of the input. @param options With the largest error.
ReferenceInput CompareWithReference(const Surface& reference, const Surface& input,
  const CleanSurface& cleaned, const Options& options, const Monitor& monitor);
}

#endif
