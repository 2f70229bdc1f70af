// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceReaders.h
 * @brief OBJ, PLY and STL in one pass that checks every count, number and index and rounds no
 * coordinate.
 *
 * VTK's readers of these formats round coordinates to single precision, read text as the number 0
 * and trust counts and indices.
 */
#ifndef BoneDecimate_Applications_SurfaceReaders_h
#define BoneDecimate_Applications_SurfaceReaders_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * @name One format each; the file is there and not empty.
 * What of the file is left aside becomes a warning, one line each.
 * @throws Failure(ExitCode::InputRejected) with one line.
 * @{
 */
vtkSmartPointer<vtkPolyData> ReadObjFile(
  const std::string& path, std::vector<std::string>& warnings);
vtkSmartPointer<vtkPolyData> ReadPlyFile(
  const std::string& path, std::vector<std::string>& warnings);

/// Three points for each triangle, as in the file.
vtkSmartPointer<vtkPolyData> ReadStlFile(
  const std::string& path, std::vector<std::string>& warnings);
/// @}
}

#endif
