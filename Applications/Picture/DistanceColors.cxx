// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceColors.h"

#include "NumberText.h"
#include "SurfaceDistances.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>

namespace bonedecimate
{
namespace
{
using Color = std::array<double, 3>;

// Entries 255, 231, ... 63 of "magma" by Nathaniel Smith and Stefan van der Walt (matplotlib, CC0),
// which is perceptually uniform. It runs from light to dark here, so that bone that did not move
// keeps the color of bone: the first entry has its lightness from magma but less yellow, which
// looks green in the shade. The last quarter, nearly black, is left out because no shape can be
// seen in it.
constexpr std::array<Color, 9> Magma = { {
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

// Their quarters, which the bar is labeled with, have few digits.
constexpr std::initializer_list<double> Ends = { 1.0, 1.2, 1.6, 2.0, 2.4, 3.0, 4.0, 5.0, 6.0, 8.0 };

// A surface without any distance still needs a bar with two ends.
constexpr double LeastRange = 0.001; // mm
}

double ColorRange(const std::vector<double>& sorted)
{
  return RoundUp(std::max(Quantile(sorted, 0.999), LeastRange), Ends);
}

vtkSmartPointer<vtkColorTransferFunction> DistanceColors(double range)
{
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (std::size_t i = 0; i < Magma.size(); ++i)
  {
    const double position = range * static_cast<double>(i) / static_cast<double>(Magma.size() - 1);
    colors->AddRGBPoint(position, Magma[i][0], Magma[i][1], Magma[i][2]);
  }
  colors->SetColorSpaceToLab();
  colors->ClampingOn();
  return colors;
}
}
