// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Extract.h
 * @brief Converts the simplified mesh to points, triangles and maps.
 *
 *     triangles     the remaining faces, in the order of the mesh
 *     points        their corners, in the order of the mesh; rounded if requested
 *     PointCount    always
 *     Distance, RunningError    if they or Origins are requested
 *     Origins       if requested
 *
 * Only the last two need the bounding tree of the original. The result does not depend on the
 * number of threads.
 */
#ifndef BoneDecimate_Core_Run_Output_Extract_h
#define BoneDecimate_Core_Run_Output_Extract_h

#include "Base/Monitor.h"
#include "Decimate/Edit/Editor.h"
#include "Mesh/Cleaning.h"
#include "Mesh/PointRounding.h"
#include "Result.h"
#include "Run/Input/Labels.h"

namespace bonedecimate
{
struct ExtractOptions
{
  PointRounding Rounding = {}; ///< Rounding of the positions, before they are measured.
  bool Distances = false;
  bool Origins = false;
  int Threads = 1;
  const Labels* InputLabels = nullptr;      ///< Labels of the input triangles; null: none.
  const LabelMapSource* LabelMap = nullptr; ///< The label map of the input; null: not known.
};

/**
 * Fills the surface, the maps and the figures of points of the result.
 * @param input Points that never moved are copied from here, bit for bit.
 * @param monitor Receives the progress of the look-ups; cannot abort them.
 * @return The points of the result relative to clean.Origin, mm, as used for measuring.
 */
std::vector<Vector3> Extract(const Surface& input, const CleanSurface& clean, const Editor& editor,
  const ExtractOptions& options, const Monitor& monitor, Result& result);
}

#endif
