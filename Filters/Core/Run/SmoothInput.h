// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmoothInput.h
 * @brief The first step of a run: smooths the cleaned input within the limits of its error bound.
 *
 *     limits      of each point, as those of edits: largest error, tolerance, what the reference
 *                 leaves; 0: constrained
 *     Smooth      the manifold patches joined, so that duplicates of a point move as one
 *       (Smoothing/Smoothing.h)
 *
 * A part of a larger surface takes the positions that its smoothing as a whole has given.
 *
 * The connectivity stays, so the displacement of a point proves its distance to the input. Edits
 * are proved against the input, too, so that errors do not add up.
 */
#ifndef BoneDecimate_Core_Run_SmoothInput_h
#define BoneDecimate_Core_Run_SmoothInput_h

#include "Decimate/Edit/EditorSettings.h"
#include "Run/Input/PrepareInput.h"

#include <vector>

namespace bonedecimate
{
/// @param settings Bound and tolerances of the editor.
/// @param figures Filled if smoothing is requested.
/// @return mm from the local origin, of each vertex of the mesh. Empty if nothing is smoothed, or
///   after an abort.
std::vector<Vector3> SmoothInput(const RunTask& task, const PreparedInput& prepared,
  const EditorSettings& settings, const Monitor& monitor, SmoothingFigures& figures);
}

#endif
