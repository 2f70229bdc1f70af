// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistinctPositions.h
 * @brief Separates vertices whose positions coincide after rounding.
 *
 * Readers merge coincident points. This would close a slit in an open boundary whose two sides have
 * vertices with the same coordinates, and the boundary of the file would differ from the proved
 * one. So one of the vertices moves to an adjacent position, by a move that is checked and proved
 * like any other.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_DistinctPositions_h
#define BoneDecimate_Core_Decimate_Stages_DistinctPositions_h

#include "Decimate/Edit/Editor.h"
#include "Mesh/PointRounding.h"

namespace bonedecimate
{
/// Must be called after all other edits, from one thread.
/// @param input The surface before cleaning.
/// @param found Receives the points that could not be separated; then the status is not good.
InputStatus SeparateCoincidentPoints(Editor& editor, const Surface& input,
  const CleanSurface& clean, const PointRounding& rounding, CleaningStatistics& found);
}

#endif
