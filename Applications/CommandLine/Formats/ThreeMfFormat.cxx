// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFormat.h"
#include "ThreeMfFiles.h"

namespace bonedecimate
{
namespace
{
SurfaceFormat ThreeMfRow()
{
#ifdef BONEDECIMATE_HAS_LIBZIP
  SurfaceFormat format = { "3mf", false, false, false, ReadThreeMfFile, WriteThreeMfFile };
#else
  SurfaceFormat format = FormatWithoutLibrary("3mf", "libzip");
#endif
  format.NamesUnit = true;
  format.ArraysHeld = [](vtkPolyData*) -> std::set<std::string> {
    return { "BoundaryLabels", "LabelValues", "LabelNames", "LabelColors", "Color" };
  };
  format.IsForPrinting = true;
  return format;
}
}

extern const SurfaceFormat ThreeMfFormat;
const SurfaceFormat ThreeMfFormat = ThreeMfRow();
}
