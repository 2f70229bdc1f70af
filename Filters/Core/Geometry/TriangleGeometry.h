// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleGeometry.h
 * @brief The area vector of a triangle, and its point nearest to a given point. Degenerate
 * triangles are allowed.
 */
#ifndef BoneDecimate_Core_Geometry_TriangleGeometry_h
#define BoneDecimate_Core_Geometry_TriangleGeometry_h

#include "Surface.h"

#include <array>
#include <vector>

namespace bonedecimate
{
/// Unit normal times area, mm^2; points outwards if the corners are counter-clockwise.
inline Vector3 AreaVector(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return 0.5 * (b - a).cross(c - a);
}

/// At each point the sum of the area vectors of its triangles.
std::vector<Vector3> AreaNormals(
  const std::vector<Vector3>& points, const std::vector<Triangle>& triangles);

/// A point on a triangle, and its distance to the query.
struct PointOnTriangle
{
  Vector3 Position = Vector3::Zero();                // mm
  std::array<double, 3> Weights = { 1.0, 0.0, 0.0 }; // barycentric
  double SquaredDistance = 0.0;                      // mm^2
};

/// The point of the segment a-b nearest to p as a fraction of the way from a to b, 0 to 1.
double NearestFraction(const Vector3& p, const Vector3& a, const Vector3& b);

/// The point of triangle a b c nearest to p (regions as in Ericson, Real-Time Collision Detection,
/// 2005, 5.1.5).
PointOnTriangle NearestOnTriangle(
  const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c);
}

#endif
