// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceArrays.h
 * @brief Points and triangles straight from and to the arrays in which VTK stores them, block by
 * block over threads.
 */
#ifndef SurfaceArrays_h
#define SurfaceArrays_h

#include "Geometry/Surface.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkCellArray;
class vtkPoints;

namespace bonedecimate
{
/// None if there is no such point.
Index ToIndex(vtkIdType id, vtkIdType numberOfPoints);

/// There must be an array of points.
std::vector<Vector3> ReadPoints(vtkPoints* points, int threads);

/// False, and nothing read, if one of the cells is no triangle. Ids out of range become None.
bool ReadTriangles(
  vtkCellArray* cells, vtkIdType numberOfPoints, int threads, std::vector<Triangle>& triangles);

/// @param single Whether to store the coordinates in single precision.
vtkSmartPointer<vtkPoints> ToPoints(const std::vector<Vector3>& from, bool single, int threads);

vtkSmartPointer<vtkCellArray> ToCells(const std::vector<Triangle>& from, int threads);
}

#endif
