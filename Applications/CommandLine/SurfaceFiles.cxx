// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFiles.h"

#include "ExitCode.h"
#include "Formats/FileChecks.h"
#include "Formats/FileParts.h"
#include "Formats/SurfaceFormat.h"
#include "VtkMessages.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// What the format's reader says about it goes to VTK's messages or to the warnings.
vtkSmartPointer<vtkPolyData> ReadFormat(const std::string& path, std::vector<std::string>& warnings)
{
  const SurfaceFormat* const format = FindFormat(path);
  if (format == nullptr)
  {
    Reject(path, "its extension is none of " + SurfaceExtensions());
  }
  return format->Read(path, warnings);
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

/// What can be read back, if it has as many points and triangles as it should.
vtkSmartPointer<vtkPolyData> Arrived(vtkPolyData* surface, const std::string& path)
{
  try
  {
    const LoadedSurface arrived = ReadSurface(path);
    const bool samePoints = !FindFormat(path)->KeepsPoints ||
      arrived.Surface->GetNumberOfPoints() == surface->GetNumberOfPoints();
    const bool isWhole = samePoints && CountFaces(arrived.Surface) == CountFaces(surface);
    return isWhole ? arrived.Surface : nullptr;
  }
  catch (const Failure&)
  {
    return nullptr;
  }
}

/// "has 1 of 3 parts as a surface ..."; empty if all are closed.
std::string OpenPartsText(vtkPolyData* surface)
{
  const std::vector<FilePart> parts = PartsOf(surface);
  const auto open =
    std::count_if(parts.begin(), parts.end(), [](const FilePart& part) { return !IsClosed(part); });
  return open == 0 ? std::string()
                   : "has " + std::to_string(open) + " of " + std::to_string(parts.size()) +
      " parts as an open surface and not as a solid, because it is not closed; slicers do not "
      "print "
      "it";
}

/// Not every writer notices a full disk; what can be read back in full has arrived.
vtkSmartPointer<vtkPolyData> WriteAndCheck(vtkPolyData* surface, const std::string& path)
{
  TakeVtkMessages();
  FindFormat(path)->Write(surface, path);
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
    Reject(path, messages.Errors.front());
  }
  for (const std::string& warning : messages.Warnings)
  {
    // The legacy reader calls it a warning that data are missing, and returns what it has.
    if (warning.compare(0, 5, "Error") == 0)
    {
      Reject(path, warning);
    }
    loaded.Warnings.push_back(PrintableText(warning));
  }
  if (!loaded.Surface || !HasWholeCells(loaded.Surface))
  {
    Reject(path, "the cells of the surface are damaged");
  }
  if (!loaded.Surface->GetPoints() || CountFaces(loaded.Surface) == 0)
  {
    Reject(path, "it holds no triangle");
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

std::string LossText(vtkPolyData* surface, const SurfaceFormat& format)
{
  const int arrays = surface->GetPointData()->GetNumberOfArrays() +
    surface->GetCellData()->GetNumberOfArrays() + surface->GetFieldData()->GetNumberOfArrays();
  std::string text;
  if (!format.HoldsArrays && arrays > 0)
  {
    text = "cannot hold arrays such as the distance of each point; --heatmap and the formats " +
      ExtensionsThat(&SurfaceFormat::HoldsArrays) + " can";
  }
  if (!format.HoldsDoubles && surface->GetPoints()->GetDataType() == VTK_DOUBLE)
  {
    text += std::string(text.empty() ? "" : ", and ") +
      "rounds the double coordinates to single precision";
  }
  const std::string open = format.IsForPrinting ? OpenPartsText(surface) : std::string();
  text += (text.empty() || open.empty() ? "" : ", and ") + open;
  return text.empty() ? text : format.Extension + (" " + text);
}
}
