// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceParts.h
 * @brief Area and volume of the parts of a surface: of its components, or of what its labels
 * enclose.
 *
 * A part is closed if as many of its triangles run along every edge in one direction as in the
 * other. This is decided by a sum over its half-edges: each edge has a random number, which is
 * added in one direction and subtracted in the other. The sum of a closed part is 0; that of an
 * open part is 0 with a probability of 2^-64.
 */
#ifndef BoneDecimate_Core_Mesh_SurfaceParts_h
#define BoneDecimate_Core_Mesh_SurfaceParts_h

#include "Geometry/Surface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// The part that the normal of a triangle points out of, and the part that it points into; None: no
/// part.
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
  double Area = 0.0;   ///< mm^2
  double Volume = 0.0; ///< mm^3, signed; only meaningful if closed.
  bool IsClosed = true;
  Vector3 Low, High; ///< mm, bounding box; not set without triangles.
};

/// @param points,triangles Corners must be valid.
std::vector<PartExtent> MeasureParts(const std::vector<Vector3>& points,
  const std::vector<Triangle>& triangles, const SurfaceParts& parts);
}

#endif
