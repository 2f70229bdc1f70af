// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WriteStl.h
 * @brief Binary STL.
 */
#ifndef BoneDecimate_Applications_WriteStl_h
#define BoneDecimate_Applications_WriteStl_h

#include "vtkPolyData.h"

#include <string>

namespace bonedecimate
{
/**
 * The triangles in single precision, little-endian. The bytes are those of vtkSTLWriter, whose
 * library needs twenty others, also those that render.
 * @throws Failure(ExitCode::CouldNotWrite)
 */
void WriteStlFile(vtkPolyData* surface, const std::string& path);
}

#endif
