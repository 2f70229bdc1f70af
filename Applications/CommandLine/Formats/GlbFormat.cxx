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
  format.WriteCompressed = WriteCompressedGlbFile;
  format.ArraysHeld = ArraysOfGlb;
#else
  SurfaceFormat format = FormatWithoutLibrary("glb", "meshoptimizer");
#endif
  format.NamesUnit = true;
  format.UnitMayDiffer = true;
  format.HasGrid = true;
  return format;
}
}

extern const SurfaceFormat GlbFormat;
const SurfaceFormat GlbFormat = GlbRow();
}
