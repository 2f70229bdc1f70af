// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleShapes.h
 * @brief The shapes of all triangles of a surface in figures, by the definitions of vtkMeshQuality.
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
/// Triangles without area count as of angle 0 and are left out of everything else.
ShapeStatistics DescribeShapes(const Surface& surface, int threads);

/// Adds the triangles of another surface.
void AddShapes(const ShapeStatistics& other, ShapeStatistics& sum);

/// The triangles with a smaller angle.
AngleFigures FindBelowAngle(const Surface& surface, double degrees);

/// The edges compared with the lengths of the limits.
/// @param origin mm, that the positions of the limits are relative to.
EdgeFigures FindEdges(const Surface& surface, const ShapeLimits& limits, const Vector3& origin);
}

#endif
