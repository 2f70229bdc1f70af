// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegionPart.h
 * @brief The part of a surface that a run over a region reads, and its result.
 *
 *     region          triangles that may change: no corner has a tolerance of 0
 *     surroundings    unchanged triangles, so many that nothing beyond them
 *                     has an influence on the region
 *     part            region and surroundings as a surface, which an ordinary run simplifies
 */
#ifndef BoneDecimate_Core_Partition_Regions_RegionPart_h
#define BoneDecimate_Core_Partition_Regions_RegionPart_h

#include "DirectionBounds.h"
#include "Run/Input/Labels.h"
#include "Run/Output/Result.h"

#include <vector>

namespace bonedecimate
{
/// Points and triangles are those of the cleaned whole surface, ascending.
struct Region
{
  std::vector<Index> Triangles;   ///< That may change.
  std::vector<Index> Points;      ///< Their corners. No other region has one of them.
  std::vector<double> Tolerances; ///< mm, of these points; negative: none.
  double Reach = 0.0;             ///< mm, within which triangles are surroundings.
  DirectionBounds Bound;          ///< Bound of these points, mm relative to the local origin.

  bool operator==(const Region& other) const
  {
    return this->Triangles == other.Triangles && this->Tolerances == other.Tolerances &&
      this->Reach == other.Reach;
  }
};

struct RegionPart
{
  Region Covered;
  bonedecimate::Surface Surface;  ///< mm, points bit for bit those of the input.
  std::vector<Index> Points;      ///< For each of its points that of the cleaned whole surface.
  std::vector<Index> Triangles;   ///< For each of its triangles, the same.
  std::vector<double> Tolerances; ///< mm, of its points; 0 at points that are not of the region.
  bonedecimate::Labels Labels;    ///< Labels of its triangles; empty: there are none.

  bonedecimate::Result Result;
  /// The unchanged triangle of each result triangle; None: it is new.
  std::vector<Index> OldTriangle;
  /// For each point of the result the corner of unchanged triangles; None: of new ones alone.
  std::vector<Index> OldPoint;
};
}

#endif
