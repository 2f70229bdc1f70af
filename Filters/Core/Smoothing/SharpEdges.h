// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpEdges.h
 * @brief Edges along which a surface is sharp at the scale of two voxels.
 *
 * The steps of a staircase have angles of 45 and 90 degrees everywhere, so the angle between two
 * neighboring triangles means nothing. Instead:
 *
 *     patch of a triangle    the triangles connected to it whose centroids are within the scale
 *                            of its own
 *     spread of a patch      1 - |sum of area vectors| / sum of areas = (1 - cos b) / 2 of a cap
 *                            of a sphere; b: its bend
 *     normal of a triangle   the mean normal of the patch of least spread among those whose
 *                            center is within the scale
 *     sharp edge             its two triangles have normals that differ by more than the angle,
 *                            and by more than twice the sum of the bends of their patches; never
 *                            where their orientations contradict
 *
 * The flattest patches lie beside an edge, so normals are constant up to the edge and differ by its
 * whole angle there, even if it is rounded. On a sphere they differ by no more than the sum of the
 * bends, on a cylinder by no more than 1.5 times that.
 *
 * M. Kuwahara et al., Processing of RI-angiocardiographic images, 1976: the mean of the most
 * homogeneous neighborhood.
 */
#ifndef BoneDecimate_Core_Smoothing_SharpEdges_h
#define BoneDecimate_Core_Smoothing_SharpEdges_h

#include "Geometry/Surface.h"

#include <array>
#include <vector>

namespace bonedecimate
{
struct SharpEdgeSettings
{
  double Angle = 180.0; ///< Degrees; edges of larger angles are sharp.
  double Scale = 0.0;   ///< Size of a patch, in the units of ToUnits.
  Eigen::Matrix3d ToUnits = Eigen::Matrix3d::Identity(); ///< From mm.
  int Threads = 1;
};

struct SharpEdges
{
  std::vector<char> IsSharp;    ///< One flag for each edge.
  std::vector<Vector3> Normals; ///< The normal of the patch of each triangle.
};

/// @param points mm, smoothed, so that the spread of a patch is its curvature and not its
///   staircase.
/// @param edges The two triangles of each edge that may be sharp. Patches do not extend over other
///   edges, nor over those with contradicting orientations.
SharpEdges FindSharpEdges(const std::vector<Vector3>& points,
  const std::vector<Triangle>& triangles, const std::vector<std::array<Index, 2>>& edges,
  const SharpEdgeSettings& settings);
}

#endif
