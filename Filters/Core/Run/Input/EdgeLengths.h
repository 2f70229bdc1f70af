// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeLengths.h
 * @brief The shapes that a run requests. Local lengths of edges, mm: an array of the input, and
 * lengths by the curvature of the input.
 *
 *     chordal      sqrt(6 R e - 3 e^2), at least EdgeLength / 10    R: radius of curvature,
 *                                                                   e: ChordalError
 *     length       the least of EdgeLength, the array and the chordal length, graded
 *
 * Documentation/how-to/triangle-shapes.md.
 */
#ifndef BoneDecimate_Core_Run_Input_EdgeLengths_h
#define BoneDecimate_Core_Run_Input_EdgeLengths_h

#include "Figures/InputFigures.h"
#include "Figures/InputStatus.h"
#include "Mesh/Cleaning.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/ShapeLimits.h"
#include "Mesh/SizingField.h"
#include "Options/Options.h"

#include <memory>
#include <vector>

namespace bonedecimate
{
/// Whether a run can use them; counts the invalid ones.  @param given mm, of each input point;
/// null: none.
InputStatus CheckEdgeLengths(
  const std::vector<double>* given, std::size_t numberOfPoints, CleaningStatistics& found);

/// mm, the side of an equilateral triangle with its corners on a sphere of that curvature (1/mm)
/// and its plane that far below it.
double ChordalLength(double curvature, double error);

/// Relative to the local origin of the input; null: EdgeLength everywhere, or none.
/// @param given As above.  @param mesh The mesh of the cleaned surface, before the first edit.
std::shared_ptr<const SizingField> MakeSizingField(const CleanSurface& clean,
  const HalfEdgeMesh& mesh, const std::vector<double>* given, const Options& options);

/// What the edits of a run keep. The least angle is a little larger than requested: the output may
/// round positions. An edge length needs one, too: slivers have edges of any length.
/// @param local Lengths of edges where they are less than EdgeLength; null: nowhere.
ShapeLimits ShapeLimitsOf(
  const Options& options, std::shared_ptr<const SizingField> local = nullptr);
}

#endif
