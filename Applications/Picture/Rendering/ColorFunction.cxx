// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorFunction.h"

#include "DistanceColors.h"

#include <cstddef>

namespace bonedecimate
{
vtkSmartPointer<vtkColorTransferFunction> MakeColorFunction(double range)
{
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (std::size_t i = 0; i < DistanceColors.size(); ++i)
  {
    const Color& color = DistanceColors[i];
    const auto part = static_cast<double>(i) / static_cast<double>(DistanceColors.size() - 1);
    colors->AddRGBPoint(part * range, color[0], color[1], color[2]);
  }
  colors->SetColorSpaceToLab();
  colors->ClampingOn();
  return colors;
}
}
