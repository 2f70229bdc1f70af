// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WritePly.h
 * @brief Binary PLY whose coordinates have the precision of the surface's.
 */
#ifndef BoneDecimate_Applications_WritePly_h
#define BoneDecimate_Applications_WritePly_h

#include "vtkPolyData.h"

#include <string>

namespace bonedecimate
{
/**
 * Points, polygons and the arrays of PlyColumns.h, little-endian. Of a surface in single precision
 * without other arrays than texture coordinates the bytes are those of vtkPLYWriter, which rounds
 * doubles.
 * @throws Failure(ExitCode::CouldNotWrite)
 */
void WritePlyFile(vtkPolyData* surface, const std::string& path);
}

#endif
