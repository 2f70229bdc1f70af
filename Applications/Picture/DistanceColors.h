// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistanceColors.h
 * @brief The colors of distances: near as bone, far as dark violet.
 */
#ifndef BoneDecimate_Applications_DistanceColors_h
#define BoneDecimate_Applications_DistanceColors_h

#include <array>
#include <vector>

namespace bonedecimate
{
/// Red, green and blue, from 0 to 1.
using Color = std::array<double, 3>;

/**
 * Colors at equal steps from no distance to the end of the colors; between them Lab is linear.
 *
 * Entries 255, 231, ... 63 of "magma" by Nathaniel Smith and Stefan van der Walt (matplotlib, CC0),
 * which is perceptually uniform. It runs from light to dark here, so that bone that did not move
 * keeps the color of bone: the first entry has its lightness from magma but less yellow, which
 * looks green in the shade. The last quarter, nearly black, is left out because no shape can be
 * seen in it.
 */
constexpr std::array<Color, 9> DistanceColors = { {
  { 0.985000, 0.965000, 0.900000 },
  { 0.995424, 0.819875, 0.579140 },
  { 0.995810, 0.646344, 0.441361 },
  { 0.975082, 0.468861, 0.363111 },
  { 0.899552, 0.314616, 0.391037 },
  { 0.761077, 0.231214, 0.460162 },
  { 0.607238, 0.179779, 0.499492 },
  { 0.457386, 0.127522, 0.507448 },
  { 0.310382, 0.069702, 0.483186 },
} };

/// How distances become colors.
struct ColorScale
{
  double Range = 0.0;     ///< Where the colors end, mm.
  double Tolerance = 0.0; ///< mm; larger distances all have the last color. 0: none.
};

/// A scale of twice a tolerance: the lower half of 256 steps is within it.
ColorScale ScaleOfTolerance(double tolerance);

/// A color of them. @param part From 0 to 1.
Color DistanceColor(double part);

/// The color of a distance, mm: light up to a tolerance, and the last color beyond.
Color DistanceColor(const ColorScale& scale, double distance);

/// Where the colors end, mm: a readable number not below 99.9 % of the distances (ascending).
double ColorRange(const std::vector<double>& sorted);
}

#endif
