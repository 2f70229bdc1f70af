// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThreeMfFiles.h
 * @brief 3MF, the core specification: a ZIP archive with a model in XML.
 *
 *     unit         millimeter
 *     object       one for each label: name, number of the label as part number, color as base material;
 *                  type "model" if its surface is closed, else "surface"
 *     build item   one for each object
 *
 * Coordinates are the shortest decimals that readers of single precision turn into the same bits. (The writer of lib3mf 1.8 cuts
 * them after six decimals and computes with single precision, which moves points by up to 3e-5 mm.)
 *
 * 3MF Consortium, 3D Manufacturing Format, Core Specification 1.3.
 */
#ifndef BoneDecimate_Applications_ThreeMfFiles_h
#define BoneDecimate_Applications_ThreeMfFiles_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace bonedecimate
{
constexpr const char* ThreeMfModel = "3D/3dmodel.model"; ///< In the archive.

/// Points in mm. @throws Failure(ExitCode::CouldNotWrite)
void WriteThreeMfFile(vtkPolyData* surface, const std::string& path);

/**
 * The meshes of a file in mm, with BoundaryLabels if this program wrote it and it has labels. Components and transforms are not
 * read: a file that has them is rejected. Colors that are no base materials are left aside.
 * @throws Failure(ExitCode::InputRejected)
 */
vtkSmartPointer<vtkPolyData> ReadThreeMfFile(
  const std::string& path, std::vector<std::string>& warnings);
}

#endif
