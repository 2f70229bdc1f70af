// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceParts.h
 * @brief Area and volume of the parts of a surface: of its components, or of what its labels
 * enclose.
 *
 * A part is closed if along every edge as many of its triangles run one way as the other. A sum
 * over the half-edges tells: each adds a random number of its edge, or subtracts it where it runs
 * to the lesser point. The sum is 0 if the part is closed, and otherwise with a probability of
 * 2^-64.
 */
#ifndef BoneDecimate_Core_Mesh_SurfaceParts_h
#define BoneDecimate_Core_Mesh_SurfaceParts_h

#include "Geometry/Surface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// The part out of which the normal of a triangle points, and the part into which it points; None:
/// no part.
using PartSides = std::array<Index, 2>;

struct SurfaceParts
{
  std::vector<PartSides> OfTriangle;
  Index Count = 0;
};

/// Each component is a part; numbered as by FindComponents.
SurfaceParts ComponentsAsParts(const Surface& surface);

struct PartExtent
{
  std::int64_t Triangles = 0;
  double Area = 0.0;    ///< mm^2
  double Volume = 0.0;  ///< mm^3, signed; meaningful if the part is closed.
  bool IsClosed = true; ///< See above.
  Vector3 Low, High;    ///< mm, corners of the box along the axes; not set without triangles.
};

/// @param points,triangles Corners must be valid.
std::vector<PartExtent> MeasureParts(const std::vector<Vector3>& points,
  const std::vector<Triangle>& triangles, const SurfaceParts& parts);
}

#endif
