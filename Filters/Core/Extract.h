// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Extract.h
 * @brief Turns what is left of the mesh into points, triangles and maps again.
 *
 *     triangles     those alive, in the order of the mesh
 *     points        those of its corners, in the order of the mesh; rounded to single precision if asked for
 *     PointCount    always
 *     Distance, RunningError    if they or Origins are asked for
 *     Origins       if asked for
 *
 * Only the last two lines need the original's bounding tree. The same result whatever the number of threads.
 */
#ifndef BoneDecimate_Core_Extract_h
#define BoneDecimate_Core_Extract_h

#include "Collapse/Editor.h"
#include "Decimate.h"
#include "Mesh/Cleaning.h"

namespace bonedecimate
{
struct ExtractOptions
{
  bool RoundToSingle = false; ///< Round the positions to single precision before they are measured.
  bool Distances = false;
  bool Origins = false;
  int Threads = 1;
  const Labels* Named = nullptr; ///< Of the input triangles; null: none.
};

/**
 * Fills the surface, the maps and the per-point figures of the result.
 * @param input Points that never moved are copied from here, bit for bit.
 * @param monitor Hears of the look-ups; it cannot stop them.
 * @return The result's points relative to clean.Origin, mm, as they are measured.
 */
std::vector<Vector3> Extract(const Surface& input, const CleanSurface& clean, const Editor& editor,
  const ExtractOptions& options, const Monitor& monitor, Result& result);
}

#endif
