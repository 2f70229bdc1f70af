// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SurfaceFormat.h"
#include "SurfaceReaders.h"
#include "WriteObj.h"

namespace bonedecimate
{
namespace
{
SurfaceFormat ObjRow()
{
  SurfaceFormat format = { "obj", false, true, true, ReadObjFile, WriteObjFile };
  format.ArraysHeld = ArraysInObj;
  format.HoldsLines = true;
  return format;
}
}

extern const SurfaceFormat ObjFormat;
const SurfaceFormat ObjFormat = ObjRow();
}
