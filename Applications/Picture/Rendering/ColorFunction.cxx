// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorFunction.h"

#include <cstddef>

namespace bonedecimate
{
vtkSmartPointer<vtkColorTransferFunction> MakeColorFunction(const ColorScale& scale)
{
  constexpr double above = 1.0 + 1e-6; // where the color changes
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  const double end = scale.Tolerance > 0.0 ? scale.Tolerance : scale.Range;
  for (std::size_t i = 0; i < DistanceColors.size(); ++i)
  {
    const auto part = static_cast<double>(i) / static_cast<double>(DistanceColors.size() - 1);
    const Color color =
      scale.Tolerance > 0.0 ? DistanceColor(scale, part * end) : DistanceColors[i];
    colors->AddRGBPoint(part * end, color[0], color[1], color[2]);
  }
  if (scale.Tolerance > 0.0)
  {
    const Color& last = DistanceColors.back();
    colors->AddRGBPoint(above * end, last[0], last[1], last[2]);
    colors->AddRGBPoint(scale.Range, last[0], last[1], last[2]);
  }
  colors->SetColorSpaceToLab();
  colors->ClampingOn();
  return colors;
}
}
