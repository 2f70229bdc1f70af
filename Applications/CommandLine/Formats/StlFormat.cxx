// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SurfaceFormat.h"
#include "SurfaceReaders.h"
#include "VtkReadersAndWriters.h"

#include "vtkNew.h"
#include "vtkSTLWriter.h"

namespace bonedecimate
{
namespace
{
vtkSmartPointer<vtkPolyData> ReadStl(const std::string& path, std::vector<std::string>&)
{
  return ReadStlFile(path);
}

void WriteStl(vtkPolyData* surface, const std::string& path)
{
  vtkNew<vtkSTLWriter> writer;
  writer->SetFileTypeToBinary();
  WriteWith(writer.Get(), surface, path);
}
}

extern const SurfaceFormat StlFormat;
const SurfaceFormat StlFormat = { "stl", false, false, false, ReadStl, WriteStl };
}
