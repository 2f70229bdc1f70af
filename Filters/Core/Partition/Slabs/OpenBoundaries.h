// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OpenBoundaries.h
 * @brief The open boundaries of a surface that arrives in slabs, and the certificate of their
 * distance.
 *
 * Edges of one triangle are boundaries. Those in a plane between two slabs count the
 * triangles of both. Boundaries are few compared with triangles, so all of them are kept and
 * compared as a whole, curve to curve.
 */
#ifndef BoneDecimate_Core_Partition_Slabs_OpenBoundaries_h
#define BoneDecimate_Core_Partition_Slabs_OpenBoundaries_h

#include "Figures/DistanceFigures.h"
#include "Geometry/Surface.h"
#include "Mesh/Cleaning.h"

#include <array>
#include <vector>

namespace bonedecimate
{
class OpenBoundaries
{
public:
  /// @param clean The slab, cleaned.  @param isInLower,isInUpper Of each point of the slab,
  /// whether it is in one of its planes.
  void Add(const Surface& slab, const CleanSurface& clean, const std::vector<char>& isInLower,
    const std::vector<char>& isInUpper);

  /// Compares them with those of the result, of which points with equal coordinates are one.
  /// @param proof Receives distances and presence; its status becomes the worse one.
  void Prove(const Surface& result, double tolerance, int threads, ErrorProof& proof);

private:
  using Ends = std::array<double, 6>; // mm, the lower end first, in the order of their coordinates

  Surface Segments;          // triangles with two equal corners
  std::vector<Ends> InPlane; // the last upper plane: once for each triangle
};
}

#endif
