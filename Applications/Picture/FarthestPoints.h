// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FarthestPoints.h
 * @brief Where two surfaces are farthest apart.
 */
#ifndef BoneDecimate_Applications_FarthestPoints_h
#define BoneDecimate_Applications_FarthestPoints_h

#include "vtkPolyData.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace bonedecimate
{
struct FarPoint
{
  double Distance = 0.0;           ///< mm, to the other surface.
  std::array<double, 3> Position;  ///< mm
  std::array<double, 3> Outward;   ///< Unit normal of the surface; zero if it has none there.
  bool IsOnOriginal = false;       ///< Otherwise it is a point of the result.
  std::vector<std::string> Labels; ///< Labels of the triangles around it, with their names.
};

struct LargestDistance
{
  double Distance = 0.0;            ///< mm; 0: not known.
  std::array<double, 3> Position{}; ///< mm
};

struct MeasuredSurface
{
  vtkPolyData* Surface = nullptr;
  std::string DistanceArrayName; ///< Point array of distances to the other surface, mm.
  LargestDistance Largest{};     ///< The largest that was measured, between points as well.
};

/**
 * The points with the largest distances, and the largest that was measured; the largest first. Of
 * points closer together than a twentieth of the diagonal of both surfaces only that of the largest
 * distance is listed.
 */
std::vector<FarPoint> FindFarthestPoints(
  const MeasuredSurface& original, const MeasuredSurface& result, std::size_t count = 10);

/// "L 12.3, P 4.5, S 100.2": mm along the axes of patients, or "12.3, 4.5, 100.2" in a frame that
/// is not known.
/// @param frame "LPS", "RAS" or empty.
std::string AnatomicalText(const std::array<double, 3>& position, const std::string& frame);

/// What the ends of the axes of a frame are called, the lower end first: "R" and "L" along x of
/// LPS, or an empty text and "x".
std::array<std::array<std::string, 2>, 3> AxisLetters(const std::string& frame);
}

#endif
