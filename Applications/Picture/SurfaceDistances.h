// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceDistances.h
 * @brief The distances that the points of a surface carry.
 */
#ifndef BoneDecimate_Applications_SurfaceDistances_h
#define BoneDecimate_Applications_SurfaceDistances_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// The triangles of a surface that have an area, polygons and strips among them, and none of the
/// points that no such triangle uses: those would neither be seen nor measured, but frame the bone
/// and stretch the colors. Point data is kept.
vtkSmartPointer<vtkPolyData> TrianglesOnly(vtkPolyData* surface);

/// TrianglesOnly() with equal points merged: STL writes a point once for each of its triangles.
vtkSmartPointer<vtkPolyData> MergedTriangles(vtkPolyData* surface);

/// The finite values of an array of the points that triangles use, ascending. Empty if there is no
/// such array.
std::vector<double> SortedDistances(vtkPolyData* triangles, const std::string& arrayName);

/// The least value that is not below that fraction of them; 0 if there are none.
double Quantile(const std::vector<double>& sorted, double fraction);
}

#endif
