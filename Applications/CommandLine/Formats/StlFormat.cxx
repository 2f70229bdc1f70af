// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileFrame.h"
#include "Formats/SurfaceFormat.h"
#include "SurfaceReaders.h"
#include "VtkReadersAndWriters.h"

#include "vtkNew.h"
#include "vtkSTLWriter.h"

namespace bonedecimate
{
namespace
{
void WriteStl(vtkPolyData* surface, const std::string& path)
{
  vtkNew<vtkSTLWriter> writer;
  writer->SetFileTypeToBinary();
  const std::string frame = FrameOf(surface);
  if (!frame.empty())
  {
    writer->SetHeader(FrameLine(frame).c_str());
  }
  WriteWith(writer.Get(), surface, path);
}

SurfaceFormat StlRow()
{
  SurfaceFormat format = { "stl", false, false, false, ReadStlFile, WriteStl };
  format.ArraysHeld = [](vtkPolyData*) -> std::set<std::string> { return { "SPACE" }; };
  return format;
}
}

extern const SurfaceFormat StlFormat;
const SurfaceFormat StlFormat = StlRow();
}
