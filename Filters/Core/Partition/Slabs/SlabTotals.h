// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlabTotals.h
 * @brief Figures of the whole surface from those of its slabs.
 *
 *     triangles, area, volume    sums; volumes relative to one position, so
 *                                that those of open slabs add up
 *     components                 of the slabs, joined where they have points in a plane in common
 */
#ifndef BoneDecimate_Core_Partition_Slabs_SlabTotals_h
#define BoneDecimate_Core_Partition_Slabs_SlabTotals_h

#include "Mesh/Cleaning.h"
#include "Run/Report/Report.h"
#include "SlabRun.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace bonedecimate
{
/// mm, over the area, as if all triangles were equilateral.
double MeanEdge(const Surface& surface);

class SlabTotals
{
public:
  /// @param clean The slab, cleaned.  @param isInLower,isInUpper Of each point, whether it is in a
  /// plane of the slab.
  void Add(const Slab& slab, const CleanSurface& clean, const std::vector<char>& isInLower,
    const std::vector<char>& isInUpper, int threads);

  /// Fills in the figures of the input.
  void Write(Report& report) const;
  /// What cleaning dropped.
  std::vector<LeftOutShape> LeftOut() const;
  std::int64_t NumberOfComponents() const;
  double Volume() const { return this->Sum.Volume; }

private:
  using Coordinates = std::array<double, 3>;
  Index RootOf(Index component) const;

  SurfaceStatistics Sum;
  CleaningStatistics Cleaning;
  std::vector<std::array<Vector3, 3>> Dropped; // mm
  std::vector<Index> Parents;                  // of components
  std::map<Coordinates, Index> InPlane;        // the last upper plane: the component of each point
};
}

#endif
