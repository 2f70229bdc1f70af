// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ObjCells.h
 * @brief Faces, lines and points of an OBJ file, and the surface that they make with its vertices.
 */
#ifndef BoneDecimate_Applications_ObjCells_h
#define BoneDecimate_Applications_ObjCells_h

#include "CoordinateCollector.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Vertex, texture coordinate and normal of a corner "v/vt/vn"; -1: none.
using ObjCorner = std::array<vtkIdType, 3>;

/// What is said once and holds for the cells that follow.
struct ObjState
{
  int Group = 0;     ///< How many groups were begun before this one.
  int Material = -1; ///< Index of its name; -1 before the first.
};

/// Cells of one kind, in the order of the file.
struct ObjCells
{
  void Add(const std::vector<ObjCorner>& corners, const ObjState& state);

  vtkNew<vtkCellArray> Vertices;
  /// Indices of each corner; empty as long as no corner names one.
  std::vector<vtkIdType> TextureCoordinates;
  std::vector<vtkIdType> Normals;
  std::vector<ObjState> States; ///< State of each cell; empty as long as all are the default.
};

/// Everything that a file holds, its indices checked.
struct ObjContent
{
  ObjContent();

  CoordinateCollector Vertices;
  vtkNew<vtkFloatArray> TextureCoordinates;
  vtkNew<vtkFloatArray> Normals;
  ObjCells Points;
  ObjCells Lines;
  ObjCells Faces;
  std::vector<std::string> Materials;
  std::vector<std::string> MaterialLibraries;
  std::vector<float> Colors; ///< Three for each vertex that has some.
  std::string Frame;         ///< FileFrame.h
};

/**
 * Texture coordinates (an array for each material) and normals become point arrays; where the
 * corners of a vertex differ in them, every corner gets a point of its own. GroupIds, if there are
 * several, and MaterialIds become cell arrays. Colors become the point array RGB if every vertex
 * has one.
 */
vtkSmartPointer<vtkPolyData> SurfaceOf(ObjContent& content);
}

#endif
