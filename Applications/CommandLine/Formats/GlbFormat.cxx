// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GlbFiles.h"
#include "SurfaceFormat.h"

namespace bonedecimate
{
namespace
{
SurfaceFormat GlbRow()
{
#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER
  SurfaceFormat format = { "glb", false, true, false, ReadGlbFile, WriteGlbFile };
#else
  SurfaceFormat format = FormatWithoutLibrary("glb", "meshoptimizer");
#endif
  format.NamesUnit = true;
  format.ArraysHeld = [](vtkPolyData*) -> std::set<std::string>
  {
    return { "BoundaryLabels", "LabelValues", "LabelNames", "LabelColors", "Color",
      VertexColorArray };
  };
  format.HasGrid = true;
  return format;
}
}

extern const SurfaceFormat GlbFormat;
const SurfaceFormat GlbFormat = GlbRow();
}
