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
#include "ShapeLimits.h"
#include "Surface.h"

namespace bonedecimate
{
/// Triangles without area count as of angle 0 and are left out of everything else.
ShapeStatistics DescribeShapes(const Surface& surface, int threads);

/// Adds the triangles of another surface.
void AddShapes(const ShapeStatistics& other, ShapeStatistics& sum);

/// What the edits of a run keep. The least angle is a little larger than requested: the output may round positions. An edge length needs
/// one, too: slivers have edges of any length.
ShapeLimits ShapeLimitsOf(const Options& options);

/// Compares the triangles with the MinimumAngle and the EdgeLength of a run.
void CompareShapes(const Surface& surface, const Options& options, Report& report);
}

#endif
