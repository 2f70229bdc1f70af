// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegionCut.h
 * @brief Finds the regions in which a surface may change, and cuts each out with its surroundings.
 *
 *     regions         connected by common points; those within reach of each other, or with
 *                     points that are neighbors, are one
 *     surroundings    triangles within reach of the convex bound of the region
 *                     (DirectionBounds.h), and two rings around it
 *
 * Nothing depends on the number of threads.
 */
#ifndef BoneDecimate_Core_Partition_Regions_RegionCut_h
#define BoneDecimate_Core_Partition_Regions_RegionCut_h

#include "Mesh/Cleaning.h"
#include "RegionPart.h"

namespace bonedecimate
{
/// @param tolerances mm, of each point of the cleaned surface; triangles with one of 0 do not
/// change.  @param reach mm
std::vector<Region> FindRegions(
  const Surface& clean, const std::vector<double>& tolerances, double reach, int threads);

/// @param input The surface of which the cleaned surface was made.
RegionPart CutRegion(
  const Surface& input, const CleanSurface& clean, const Region& region, int threads);
}

#endif
