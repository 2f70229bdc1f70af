// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComparedFigures.h
 * @brief What a certificate tells of each of its surfaces.
 */
#ifndef BoneDecimate_Core_Figures_ComparedFigures_h
#define BoneDecimate_Core_Figures_ComparedFigures_h

#include "SurfaceFigures.h"

#include <cstdint>

namespace bonedecimate
{
struct ComparedFigures
{
  /// After equal points are merged and triangles without area are left out.
  SurfaceStatistics Surface;
  std::int64_t IntersectingPairs = 0; ///< Pairs of its triangles.
};
}

#endif
