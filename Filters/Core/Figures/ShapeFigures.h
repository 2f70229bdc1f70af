// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeFigures.h
 * @brief What the report says about the shapes of triangles.
 */
#ifndef BoneDecimate_Core_Figures_ShapeFigures_h
#define BoneDecimate_Core_Figures_ShapeFigures_h

#include "Geometry/Surface.h"

#include <array>
#include <cstdint>
#include <limits>

namespace bonedecimate
{
/// Shapes of the triangles of a surface as vtkMeshQuality defines them; not a number if no triangle
/// has an area.
struct ShapeStatistics
{
  double SmallestAngle = std::numeric_limits<double>::quiet_NaN();   ///< degrees
  double MaxAngle = std::numeric_limits<double>::quiet_NaN();        ///< degrees
  double MeanRadiusRatio = std::numeric_limits<double>::quiet_NaN(); ///< 1 is equilateral.
  double MaxRadiusRatio = std::numeric_limits<double>::quiet_NaN();
  double MeanAspectRatio = std::numeric_limits<double>::quiet_NaN(); ///< 1 is equilateral.
  double MaxAspectRatio = std::numeric_limits<double>::quiet_NaN();
  /// How many triangles have a smallest angle below 10 degrees, from
  /// 10 to below 20, ... from 50 on.
  std::array<std::int64_t, 6> MinAngles{};
};

/// Triangles of the result with an angle below MinimumAngle.
struct AngleFigures
{
  std::int64_t Below = 0;
  /// mm, the centroid of the one with the smallest angle, if there is one.
  Vector3 Worst = Vector3::Zero();
};

/// Edges of the result against EdgeLength, or what is less at their ends.
struct EdgeFigures
{
  /// mm, of all local lengths, or EdgeLength.
  double MinRequested = std::numeric_limits<double>::quiet_NaN();
  double Mean = std::numeric_limits<double>::quiet_NaN();    ///< mm; not a number if there is none.
  double Longest = std::numeric_limits<double>::quiet_NaN(); ///< mm
  std::int64_t Longer = 0;                                   ///< Than 4/3 of it.
  std::int64_t Shorter = 0;                                  ///< Than 4/5 of it.
  /// mm, the middle of the one that exceeds its length most, if one is longer.
  Vector3 Worst = Vector3::Zero();
};
}

#endif
