// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WriteObj.h
 * @brief OBJ with what belongs to the surface: colors, texture coordinates, normals, groups and
 * materials.
 *
 * Not by VTK, whose writer gives a surface of several materials the points of each of them, so that
 * it is another surface.
 */
#ifndef BoneDecimate_Applications_WriteObj_h
#define BoneDecimate_Applications_WriteObj_h

#include "vtkPolyData.h"

#include <set>
#include <string>

namespace bonedecimate
{
/// Names of the arrays of points, cells and fields that the file holds.
std::set<std::string> ArraysInObj(vtkPolyData* surface);

/// Coordinates are the shortest decimals that are read as the same numbers. @throws
/// Failure(ExitCode::CouldNotWrite)
void WriteObjFile(vtkPolyData* surface, const std::string& path);
}

#endif
