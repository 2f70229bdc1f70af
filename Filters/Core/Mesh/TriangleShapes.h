// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleShapes.h
 * @brief Figures of the shapes of all triangles of a surface, by the definitions of vtkMeshQuality.
 *
 *     radius ratio   circumradius / (2 inradius): 1 for an equilateral triangle
 *     aspect ratio   longest side / (2 sqrt(3) inradius): 1 for an equilateral triangle
 */
#ifndef BoneDecimate_Core_Mesh_TriangleShapes_h
#define BoneDecimate_Core_Mesh_TriangleShapes_h

#include "Figures/ShapeFigures.h"
#include "Geometry/Surface.h"
#include "ShapeLimits.h"

namespace bonedecimate
{
/// Triangles without area have an angle of 0 and are left out of all other figures.
ShapeStatistics DescribeShapes(const Surface& surface, int threads);

/// Adds the triangles of another surface.
void AddShapes(const ShapeStatistics& other, ShapeStatistics& sum);

/// Counts the triangles with a smaller angle.
AngleFigures FindBelowAngle(const Surface& surface, double degrees);

/// Compares the edges with the requested lengths.
/// @param origin mm, the local origin of the limits.
EdgeFigures FindEdges(const Surface& surface, const ShapeLimits& limits, const Vector3& origin);
}

#endif
