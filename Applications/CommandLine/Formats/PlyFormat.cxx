// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SurfaceFormat.h"
#include "PlyColumns.h"
#include "SurfaceReaders.h"
#include "WritePly.h"

namespace bonedecimate
{
namespace
{
SurfaceFormat PlyRow()
{
  SurfaceFormat format = { "ply", false, true, true, ReadPlyFile, WritePlyFile };
  format.ArraysHeld = ArraysInPly;
  return format;
}
}

extern const SurfaceFormat PlyFormat;
const SurfaceFormat PlyFormat = PlyRow();
}
