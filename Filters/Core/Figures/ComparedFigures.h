// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComparedFigures.h
 * @brief What a certificate tells of each of its surfaces.
 */
#ifndef BoneDecimate_Core_Figures_ComparedFigures_h
#define BoneDecimate_Core_Figures_ComparedFigures_h

#include "SurfaceFigures.h"

#include <array>
#include <cstdint>

namespace bonedecimate
{
struct ComparedFigures
{
  /// After equal points are merged and triangles without area are left out.
  SurfaceStatistics Surface;
  std::int64_t IntersectingPairs = 0; ///< Pairs of its triangles.
  double Diagonal = 0.0;              ///< Diagonal of the bounding box, mm.
  std::uint64_t Checksum = 0;         ///< TriangleChecksum() of all triangles.
};

/// A component of the reference that has no counterpart in the result.
struct MissingComponent
{
  std::int64_t Triangles = 0;
  double Diagonal = 0.0;          ///< Diagonal of its bounding box, mm.
  std::array<double, 3> Center{}; ///< Center of its bounding box, mm.
};
}

#endif
