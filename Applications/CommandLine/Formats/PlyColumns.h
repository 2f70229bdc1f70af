// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlyColumns.h
 * @brief The arrays of points or faces that a PLY file holds, as its properties.
 *
 *     colors, three or four bytes        red green blue (alpha)
 *     active normals of points           nx ny nz
 *     active texture of points           u v
 *     other numbers of up to 32 bits     the name of the array; with several components NAME_0,
 *                                        NAME_1, ...
 *
 * Arrays that a run adds (distances, maps, labels) are left to vtp and vtk.
 */
#ifndef BoneDecimate_Applications_PlyColumns_h
#define BoneDecimate_Applications_PlyColumns_h

#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <set>
#include <string>
#include <vector>

namespace bonedecimate
{
struct PlyColumn
{
  vtkDataArray* Array;
  std::vector<std::string> Properties; ///< One for each component.
};

std::vector<PlyColumn> PointColumns(vtkPolyData* surface);

/// Columns of the faces. Values are in the order of cells, which begin with vertices and lines.
std::vector<PlyColumn> FaceColumns(vtkPolyData* surface);

/// "float", "uchar"; null if the format has no such type.
const char* PlyTypeName(int type);

/// Names of all arrays that the file holds.
std::set<std::string> ArraysInPly(vtkPolyData* surface);
}

#endif
