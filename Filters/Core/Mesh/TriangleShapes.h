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

#include <memory>

namespace bonedecimate
{
/// Triangles without area count as of angle 0 and are left out of everything else.
ShapeStatistics DescribeShapes(const Surface& surface, int threads);

/// Adds the triangles of another surface.
void AddShapes(const ShapeStatistics& other, ShapeStatistics& sum);

/// What the edits of a run keep. The least angle is a little larger than requested: the output may
/// round positions. An edge length needs one, too: slivers have edges of any length.
/// @param local Lengths of edges where they are less than EdgeLength; null: nowhere.
ShapeLimits ShapeLimitsOf(
  const Options& options, std::shared_ptr<const SizingField> local = nullptr);

/// Compares the triangles with the MinimumAngle and the edge lengths of a run.
/// @param origin mm, that the positions of the limits are relative to.
void CompareShapes(const Surface& surface, const Options& options, const ShapeLimits& limits,
  const Vector3& origin, Report& report);
}

#endif
