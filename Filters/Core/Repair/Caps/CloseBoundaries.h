// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloseBoundaries.h
 * @brief Closes open boundaries of a surface by triangles, on request. Error bounds do not include
 * these.
 */
#ifndef BoneDecimate_Core_Repair_Caps_CloseBoundaries_h
#define BoneDecimate_Core_Repair_Caps_CloseBoundaries_h

#include "CapTriangles.h"
#include "Geometry/Surface.h"

#include <utility>
#include <vector>

namespace bonedecimate
{
struct CapOptions
{
  bool ClosesAll = false;       ///< Also boundaries that are not at planes where the surface ends.
  double PlaneTolerance = 0.01; ///< mm
};

/// What was added to a surface.
struct CapsOfSurface
{
  std::vector<Triangle> Triangles; ///< All caps; ids from the number of points on are new points.
  std::vector<Index> Neighbors;    ///< For each triangle one of the surface beside its cap.
  std::vector<Vector3> Points;     ///< mm, the new ones.
  std::vector<PointPair> Ends;     ///< For each new point the two points that it halves.
  Index NumberOfCaps = 0;
  double Area = 0.0; ///< mm^2
  Index ClosedLoops = 0;
  Index OpenLoops = 0; ///< Those at non-manifold edges, too.
};

/// @param triangulate Finds the triangles of planar contours.
CapsOfSurface CloseBoundaries(
  Surface surface, const CapOptions& options, const ContourTriangulator& triangulate);
}

#endif
