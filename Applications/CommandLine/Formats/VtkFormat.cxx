// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "VtkReadersAndWriters.h"

#include "vtkNew.h"
#include "vtkPolyDataReader.h"
#include "vtkPolyDataWriter.h"

namespace bonedecimate
{
namespace
{
vtkSmartPointer<vtkPolyData> ReadVtk(const std::string& path, std::vector<std::string>&)
{
  CoordinateCollector textPoints;
  CheckVtkFile(path, textPoints);
  return ReadWith(vtkNew<vtkPolyDataReader>().Get(), path, textPoints);
}

void WriteVtk(vtkPolyData* surface, const std::string& path)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetFileTypeToBinary();
  WriteWith(writer.Get(), surface, path);
}

SurfaceFormat VtkRow()
{
  SurfaceFormat format = { "vtk", true, true, true, ReadVtk, WriteVtk };
  format.Check = CheckVtkFile;
  return format;
}
}

extern const SurfaceFormat VtkFormat;
const SurfaceFormat VtkFormat = VtkRow();
}
