// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SurfaceFormat.h"
#include "SurfaceReaders.h"
#include "WritePly.h"

namespace bonedecimate
{

extern const SurfaceFormat PlyFormat;
const SurfaceFormat PlyFormat = { "ply", false, true, true, ReadPlyFile, WritePlyFile };
}
