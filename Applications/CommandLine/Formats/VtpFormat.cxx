// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "VtkReadersAndWriters.h"

#include "vtkNew.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

namespace bonedecimate
{
namespace
{
vtkSmartPointer<vtkPolyData> ReadVtp(const std::string& path, std::vector<std::string>&)
{
  CoordinateCollector textPoints;
  CheckVtpFile(path, textPoints);
  return ReadWith(vtkNew<vtkXMLPolyDataReader>().Get(), path, textPoints);
}

void WriteVtp(vtkPolyData* surface, const std::string& path)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  WriteWith(writer.Get(), surface, path);
}

SurfaceFormat VtpRow()
{
  SurfaceFormat format = { "vtp", true, true, true, ReadVtp, WriteVtp };
  format.Check = CheckVtpFile;
  return format;
}
}

extern const SurfaceFormat VtpFormat;
const SurfaceFormat VtpFormat = VtpRow();
}
