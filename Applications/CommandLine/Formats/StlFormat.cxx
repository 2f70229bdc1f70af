// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SurfaceFormat.h"
#include "SurfaceReaders.h"
#include "WriteStl.h"

namespace bonedecimate
{
namespace
{
SurfaceFormat StlRow()
{
  SurfaceFormat format = { "stl", false, false, false, ReadStlFile, WriteStlFile };
  format.ArraysHeld = [](vtkPolyData*) -> std::set<std::string> { return { "SPACE" }; };
  return format;
}
}

extern const SurfaceFormat StlFormat;
const SurfaceFormat StlFormat = StlRow();
}
