// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BruteForce.h
 * @brief Brute-force reference implementations for tests of the core, without any of its code.
 */
#ifndef BoneDecimate_Testing_BruteForce_h
#define BoneDecimate_Testing_BruteForce_h

#include "Geometry/Surface.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace bonedecimate::testsupport
{
/// Distance in mm by projection onto the plane, else the edges, in long double.
double PointTriangleDistance(
  const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c);

struct NearestTriangle
{
  Index Triangle = None;
  double Distance = 0.0; ///< mm
};

/// Tries every triangle; the first of the least distance.
NearestTriangle BruteNearest(const Surface& surface, const Vector3& p);

/// Tries every point that a triangle uses; the least id of the least distance.
Index BruteNearestPoint(const Surface& surface, const Vector3& p);

/// Counts by plain maps over points and edges.
struct Topology
{
  std::int64_t Points = 0; ///< Points that a triangle uses.
  std::int64_t Edges = 0;
  std::int64_t Faces = 0;
  std::int64_t Components = 0;        ///< Components, connected by shared points.
  std::int64_t BoundaryEdges = 0;     ///< Edges of one triangle.
  std::int64_t NonManifoldEdges = 0;  ///< Edges of three or more triangles.
  std::int64_t InconsistentEdges = 0; ///< Edges along which two triangles run the same way.
  std::int64_t NonManifoldPoints = 0; ///< Points whose triangles are not one fan.
  std::int64_t EulerNumber = 0;       ///< Points - edges + faces.

  bool operator==(const Topology& other) const;
};

Topology CountTopology(const Surface& surface);

/// Component number of each triangle, numbered by first triangle; triangles with a common point
/// belong together.
std::vector<Index> ComponentOfTriangles(const Surface& surface);

/// Each component as a surface of its own; all of them keep all points.
std::vector<Surface> SplitComponents(const Surface& surface);

/// mm^3, by the divergence theorem about the origin.
double SignedVolume(const Surface& surface);

/// mm^2
double TotalArea(const Surface& surface);

/// Boundary edges in the direction of their triangle.
std::vector<std::pair<Index, Index>> BoundaryEdges(const Surface& surface);

/// Number of edges of each closed boundary loop; only for boundaries where each point has one way
/// out.
std::vector<std::int64_t> BoundaryLoopLengths(const Surface& surface);

/// Number of triangles that repeat another one of the same three points in whatever order.
std::int64_t RepeatedTriangles(const Surface& surface);

/// Empty if every triangle has three different points that exist, is finite and every point is
/// used; else why not.
std::string WhatIsWrong(const Surface& surface);

/// Whether both have the same points and triangles bit for bit, in whatever order; triangles begin
/// at the same corner.
bool SameInAnyOrder(const Surface& a, const Surface& b);

/// Whether both are the same bit for bit.
bool SameBytes(const Surface& a, const Surface& b);
}

#endif
