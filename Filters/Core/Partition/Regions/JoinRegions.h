// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JoinRegions.h
 * @brief Puts the results of regions into the unchanged rest of the surface.
 *
 *     triangles    the unchanged ones in the order of the input, then the new ones of each region
 *     points       those of unchanged triangles in the order of the input,
 *                  then the new ones of each region
 *
 * CheckJoined() compares the result with the input by coordinates alone, so that an error of
 * joining cannot hide.
 */
#ifndef BoneDecimate_Core_Partition_Regions_JoinRegions_h
#define BoneDecimate_Core_Partition_Regions_JoinRegions_h

#include "RegionCache.h"

#include <map>
#include <memory>
#include <vector>

namespace bonedecimate
{
using RegionParts = std::vector<std::shared_ptr<const RegionPart>>;

/// The surface of a result and where it comes from.
struct JoinedRegions
{
  bonedecimate::Surface Surface;
  std::vector<Index> UnchangedTriangle; ///< The cleaned triangle of each of the first ones.
  std::vector<Index> UnchangedPoint;    ///< The cleaned point of each of the first ones.
  /// The point of the surface for each part and each point of its result.
  std::vector<std::vector<Index>> PointOfPart;
  std::vector<Index> OutputPoint; ///< The point of each cleaned one; None: it was removed.
};

/// The regions of the parts must have no point in common.
JoinedRegions JoinRegions(
  const Surface& input, const WholeSurface& whole, const RegionParts& parts, int threads);

/**
 * Whether the surface is the input but for the regions, by coordinates:
 *     each unchanged triangle is one of the input; every other triangle
 *       is a new one of a part, in order
 *     each triangle that cleaning kept is unchanged or one of a part
 *     each triangle of a part's result is new, or unchanged in the surface
 * Then a distance proved between each part and its result holds for the whole.
 */
bool CheckJoined(const Surface& input, const WholeSurface& whole, const RegionParts& parts,
  const JoinedRegions& joined, int threads);

struct RequestedArrays
{
  bool Distances, Origins, ErrorBound;
};

/// Counts, arrays and maps of the result.
void FillJoined(const WholeSurface& whole, const RegionParts& parts, JoinedRegions& joined,
  const RequestedArrays& requested, Result& result);

/// Area and volume by which edits changed a component.
struct ExtentChange
{
  double Area = 0.0;   ///< mm^2
  double Volume = 0.0; ///< mm^3
};

/// By component.
std::map<Index, ExtentChange> ChangesOfComponents(
  const WholeSurface& whole, const RegionParts& parts);
}

#endif
