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

#include "Report/Report.h"
#include "Surface.h"

namespace bonedecimate
{
/// Triangles without area count as of angle 0 and are left out of everything else.
ShapeStatistics DescribeShapes(const Surface& surface, int threads);

/// Adds the triangles of another surface.
void AddShapes(const ShapeStatistics& other, ShapeStatistics& sum);

/// The triangles with an angle below that of MinimumAngle. @param degrees 0: none.
AngleFigures FindBelowAngle(const Surface& surface, double degrees);
}

#endif
