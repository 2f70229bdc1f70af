// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Extract.h
 * @brief Turns what is left of the mesh into points, triangles and maps again.
 */
#ifndef BoneDecimate_Core_Extract_h
#define BoneDecimate_Core_Extract_h

#include "Collapse/Editor.h"
#include "Decimate.h"
#include "Mesh/Cleaning.h"

namespace bonedecimate
{
/**
 * Fills the surface, the maps and the per-point figures of the result.
 * @param input Points that never moved are copied from here, bit for bit.
 * @param roundToSingle Round the positions to single precision before they are measured.
 * @return The result's points relative to clean.Origin, mm, as they are measured.
 */
std::vector<Vector3> Extract(const Surface& input, const CleanSurface& clean, const Editor& editor,
  bool roundToSingle, Result& result);
}

#endif
