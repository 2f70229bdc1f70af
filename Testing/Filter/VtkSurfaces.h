// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VtkSurfaces.h
 * @brief The surfaces of Testing/Support as polydata and back, and what VTK itself counts and
 * measures on them.
 */
#ifndef BoneDecimate_Testing_VtkSurfaces_h
#define BoneDecimate_Testing_VtkSurfaces_h

#include "Geometry/Surface.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace bonedecimate::testsupport
{
/// Points of that type (VTK_FLOAT, VTK_DOUBLE, ...) and triangles, no arrays.
vtkSmartPointer<vtkPolyData> PolyData(const Surface& surface, int pointType = VTK_DOUBLE);

/// A sphere of 20 * 4^levels triangles, radius 10 mm, all double.
vtkSmartPointer<vtkPolyData> Sphere(int levels);

/// Sphere() with random bumps of up to 5 %.
vtkSmartPointer<vtkPolyData> Bumps(int levels);

/// Points and polygons; every polygon must be a triangle.
Surface SurfaceOf(vtkPolyData* polyData);

/// A point array as doubles; empty if it is not there.
std::vector<double> Values(vtkPolyData* polyData, const std::string& arrayName);

double Sum(const std::vector<double>& values);
double Largest(const std::vector<double>& values);

/// Distance in mm of each point to the surface, by vtkCellLocator.
std::vector<double> LocatorDistances(const std::vector<Vector3>& points, vtkPolyData* surface);
std::vector<double> LocatorDistances(vtkPolyData* from, vtkPolyData* to);

/// What VTK's own filters find.
struct VtkCounts
{
  vtkIdType BoundaryEdges = 0;
  vtkIdType NonManifoldEdges = 0;
  vtkIdType Components = 0;
};
VtkCounts CountWithVtk(vtkPolyData* polyData);

/// Empty if every cell has existing points and every triangle three different ones; else what is
/// wrong.
std::string WhatIsWrongWith(vtkPolyData* polyData);
}

#endif
