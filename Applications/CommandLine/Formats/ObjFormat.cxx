// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SurfaceFormat.h"
#include "SurfaceReaders.h"
#include "VtkReadersAndWriters.h"

#include "vtkNew.h"
#include "vtkOBJWriter.h"

namespace bonedecimate
{
namespace
{
void WriteObj(vtkPolyData* surface, const std::string& path)
{
  WriteWith(vtkNew<vtkOBJWriter>().Get(), surface, path);
}
}

extern const SurfaceFormat ObjFormat;
const SurfaceFormat ObjFormat = { "obj", false, true, true, ReadObjFile, WriteObj };
}
