// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThreeMfFiles.h
 * @brief 3MF, the core specification: a ZIP archive with a model in XML.
 *
 *     unit         millimeter
 *     object  one for each label: name, number of the label as part number, color as base material;
 *                  type "model" if its surface is closed, else "surface"
 *     build item   one for each object
 *
 * Coordinates are decimals that equal the numbers of single precision, whatever the precision of a
 * reader. (The writer of lib3mf 1.8 cuts them after six decimals and computes with single
 * precision, which moves points by up to 3e-5 mm.)
 *
 * Read are the objects that the build uses, with components, transforms and the parts of the
 * production extension. Objects for supports, items that are not printable (an attribute of
 * slicers) and beam lattices are named in a warning; another extension that is required is a
 * rejection.
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
 * What the build of a file makes, in mm, with BoundaryLabels if this program wrote it and it has
 * labels. Colors that are no base materials are left aside.
 * @throws Failure(ExitCode::InputRejected)
 */
vtkSmartPointer<vtkPolyData> ReadThreeMfFile(
  const std::string& path, std::vector<std::string>& warnings);
}

#endif
