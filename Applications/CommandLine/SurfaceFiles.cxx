// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFiles.h"

#include "ExitCode.h"
#include "FileChecks.h"
#include "SurfaceFormat.h"
#include "SurfaceReaders.h"
#include "VtkMessages.h"
#include "WritePly.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPointData.h"
#include "vtkPolyDataReader.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

namespace bonedecimate
{
namespace
{
template <typename Reader>
vtkSmartPointer<vtkPolyData> ReadWith(Reader* reader, const std::string& path)
{
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// What the format's reader says about it goes to VTK's messages or to the warnings.
vtkSmartPointer<vtkPolyData> ReadFormat(const std::string& path, std::vector<std::string>& warnings)
{
  switch (FormatOf(path))
  {
    case SurfaceFormat::Obj:
      return ReadObjFile(path, warnings);
    case SurfaceFormat::Ply:
      return ReadPlyFile(path, warnings);
    case SurfaceFormat::Stl:
      return ReadStlFile(path);
    case SurfaceFormat::Vtp:
      CheckVtpFile(path);
      return ReadWith(vtkNew<vtkXMLPolyDataReader>().Get(), path);
    case SurfaceFormat::Vtk:
      CheckVtkFile(path);
      return ReadWith(vtkNew<vtkPolyDataReader>().Get(), path);
    case SurfaceFormat::Unknown:
      break;
  }
  Refuse(path, std::string("its extension is none of ") + SurfaceExtensions);
}

/// Offsets that run backwards or past the end would take every later step out of its arrays.
bool HasWholeCells(vtkPolyData* surface)
{
  return surface->GetVerts()->IsValid() && surface->GetLines()->IsValid() &&
    surface->GetPolys()->IsValid() && surface->GetStrips()->IsValid();
}

vtkIdType CountFaces(vtkPolyData* surface)
{
  return surface->GetPolys()->GetNumberOfCells() + surface->GetStrips()->GetNumberOfCells();
}

template <typename Writer>
void WriteWith(Writer* writer, vtkPolyData* surface, const std::string& path)
{
  writer->SetFileName(path.c_str());
  writer->SetInputData(surface);
  writer->Write();
  const unsigned long error = writer->GetErrorCode();
  if (error != vtkErrorCode::NoError)
  {
    const bool full = error == vtkErrorCode::OutOfDiskSpaceError;
    throw Failure(ExitCode::CouldNotWrite,
      full ? "the disk is full" : vtkErrorCode::GetStringFromErrorCode(error));
  }
}

void WriteFormat(vtkPolyData* surface, const std::string& path)
{
  switch (FormatOf(path))
  {
    case SurfaceFormat::Obj:
      return WriteWith(vtkNew<vtkOBJWriter>().Get(), surface, path);
    case SurfaceFormat::Ply:
      return WritePlyFile(surface, path);
    case SurfaceFormat::Stl:
    {
      vtkNew<vtkSTLWriter> writer;
      writer->SetFileTypeToBinary();
      return WriteWith(writer.Get(), surface, path);
    }
    case SurfaceFormat::Vtp:
    {
      vtkNew<vtkXMLPolyDataWriter> writer;
      writer->SetDataModeToAppended();
      writer->EncodeAppendedDataOff();
      writer->SetCompressorTypeToZLib();
      return WriteWith(writer.Get(), surface, path);
    }
    case SurfaceFormat::Vtk:
    {
      vtkNew<vtkPolyDataWriter> writer;
      writer->SetFileTypeToBinary();
      return WriteWith(writer.Get(), surface, path);
    }
    case SurfaceFormat::Unknown:
      break;
  }
}

/// What can be read back, if it has as many points and triangles as it should.
vtkSmartPointer<vtkPolyData> Arrived(vtkPolyData* surface, const std::string& path)
{
  try
  {
    const LoadedSurface arrived = ReadSurface(path);
    const bool samePoints =
      FormatOf(path) == SurfaceFormat::Stl || // three of its own for every triangle
      arrived.Surface->GetNumberOfPoints() == surface->GetNumberOfPoints();
    const bool isWhole = samePoints && CountFaces(arrived.Surface) == CountFaces(surface);
    return isWhole ? arrived.Surface : nullptr;
  }
  catch (const Failure&)
  {
    return nullptr;
  }
}

/// Not every writer notices a full disk; what can be read back in full has arrived.
vtkSmartPointer<vtkPolyData> WriteAndCheck(vtkPolyData* surface, const std::string& path)
{
  TakeVtkMessages();
  WriteFormat(surface, path);
  const VtkMessages messages = TakeVtkMessages();
  if (!messages.Errors.empty())
  {
    throw Failure(ExitCode::CouldNotWrite, messages.Errors.front());
  }
  vtkSmartPointer<vtkPolyData> arrived = Arrived(surface, path);
  if (!arrived)
  {
    throw Failure(ExitCode::CouldNotWrite, "the file is not complete, the disk may be full");
  }
  return arrived;
}
}

LoadedSurface ReadSurface(const std::string& path)
{
  LoadedSurface loaded;
  CheckFile(path);
  TakeVtkMessages();
  loaded.Surface = ReadFormat(path, loaded.Warnings);
  const VtkMessages messages = TakeVtkMessages();
  if (!messages.Errors.empty())
  {
    Refuse(path, messages.Errors.front());
  }
  for (const std::string& warning : messages.Warnings)
  {
    // The legacy reader calls it a warning that data are missing, and returns what it has.
    if (warning.compare(0, 5, "Error") == 0)
    {
      Refuse(path, warning);
    }
    loaded.Warnings.push_back(PrintableText(warning));
  }
  if (!loaded.Surface || !HasWholeCells(loaded.Surface))
  {
    Refuse(path, "the cells of the surface are damaged");
  }
  if (!loaded.Surface->GetPoints() || CountFaces(loaded.Surface) == 0)
  {
    Refuse(path, "it holds no triangle");
  }
  return loaded;
}

vtkSmartPointer<vtkPolyData> WriteSurface(
  vtkPolyData* surface, const std::string& path, const std::string& target)
{
  try
  {
    return WriteAndCheck(surface, path);
  }
  catch (const Failure& failure)
  {
    throw Failure(failure.Code, "could not write '" + target + "': " + failure.what());
  }
}

std::string LossText(vtkPolyData* surface, const std::string& path)
{
  const SurfaceFormat format = FormatOf(path);
  const int arrays = surface->GetPointData()->GetNumberOfArrays() +
    surface->GetCellData()->GetNumberOfArrays() + surface->GetFieldData()->GetNumberOfArrays();
  std::string text;
  if (!HoldsArrays(format) && arrays > 0)
  {
    text = "cannot hold arrays such as the distance of each point; .vtp, .vtk and --heatmap can";
  }
  if (!HoldsDoubles(format) && surface->GetPoints()->GetDataType() == VTK_DOUBLE)
  {
    text += std::string(text.empty() ? "" : ", and ") +
      "rounds the double coordinates to single precision";
  }
  return text.empty() ? text : ExtensionOf(path) + " " + text;
}
}
