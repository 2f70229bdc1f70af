// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointGrid.h
 * @brief The grid of files whose coordinates are whole numbers of 16 bits.
 *
 * The step is a power of two, in mm, and every coordinate a whole multiple of it. So coordinates
 * are exact in single precision, whatever arithmetic decodes them, and files that have points in
 * common have the same coordinates there.
 */
#ifndef BoneDecimate_Applications_PointGrid_h
#define BoneDecimate_Applications_PointGrid_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>

namespace bonedecimate
{
constexpr int LeastPositionBits = 8;
constexpr int MostPositionBits = 16;

/// The finest step, mm, of which so many bits count across the surface and what is near to it.
/// @param margin mm, how far outside of its bounding box points may come to lie.
double GridStepOf(vtkPolyData* surface, double margin, int bits);

/// How far rounding to the grid moves a point at most, mm.
double LargestGridRounding(double step);

/// The surface with its points rounded to the grid.
vtkSmartPointer<vtkPolyData> RoundedToGrid(vtkPolyData* surface, double step);

/// The grid of points that were rounded.
struct PointGrid
{
  double Step = 1.0; ///< mm
  std::array<double, 3> Origin = {};
};

/// The coarsest grid that has all points exactly; none if 65536 steps do not reach across them.
std::optional<PointGrid> FindGrid(vtkPolyData* surface);
}

#endif
