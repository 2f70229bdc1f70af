// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFiles.h"

#include "Base/Text.h"
#include "ExitCode.h"
#include "FilePath.h"
#include "Formats/FileChecks.h"
#include "Formats/FileFrame.h"
#include "Formats/FileParts.h"
#include "Formats/FileUnit.h"
#include "Formats/SurfaceFormat.h"
#include "NamedLabels.h"
#include "Terminal/VtkMessages.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <filesystem>
#include <set>

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

/// Why what was written cannot be read.
std::string LackOfFile(const std::string& path)
{
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(
    FilePath(path).parent_path().empty() ? FilePath(".") : FilePath(path).parent_path(), error);
  constexpr std::uintmax_t block = 65536;
  return !error && space.available < block ? "the disk is full"
                                           : "the system did not take the whole file";
}

vtkIdType CountFaces(vtkPolyData* surface)
{
  return surface->GetPolys()->GetNumberOfCells() + surface->GetStrips()->GetNumberOfCells();
}

/// What can be read back; a failure if it has not as many points and triangles as it should.
vtkSmartPointer<vtkPolyData> Arrived(vtkPolyData* surface, const std::string& path)
{
  LoadedSurface arrived;
  try
  {
    arrived = ReadSurface(path);
  }
  catch (const Failure&)
  {
    throw Failure(ExitCode::CouldNotWrite, LackOfFile(path));
  }
  const vtkIdType points = arrived.Surface->GetNumberOfPoints();
  const vtkIdType faces = CountFaces(arrived.Surface);
  const bool samePoints = !FindFormat(path)->KeepsPoints || points == surface->GetNumberOfPoints();
  if (!samePoints || faces != CountFaces(surface))
  {
    throw Failure(ExitCode::CouldNotWrite,
      "what was written has " + std::to_string(points) + " points and " + std::to_string(faces) +
        " triangles, not " + std::to_string(surface->GetNumberOfPoints()) + " and " +
        std::to_string(CountFaces(surface)) + "; another format may hold the surface");
  }
  return arrived.Surface;
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

/// Names of the arrays that a file of this format lacks; the report is one of them.
std::vector<std::string> MissingArrays(vtkPolyData* surface, const SurfaceFormat& format)
{
  const std::set<std::string> held =
    format.ArraysHeld != nullptr ? format.ArraysHeld(surface) : std::set<std::string>();
  std::vector<std::string> missing;
  bool hasReport = false;
  for (vtkFieldData* data : { static_cast<vtkFieldData*>(surface->GetPointData()),
         static_cast<vtkFieldData*>(surface->GetCellData()), surface->GetFieldData() })
  {
    for (int i = 0; !format.HoldsArrays && i < data->GetNumberOfArrays(); ++i)
    {
      const char* const given = data->GetArrayName(i);
      const std::string name = given != nullptr ? given : "";
      const bool isReport =
        LowerCase(name).rfind("bonedecimate", 0) == 0 && data == surface->GetFieldData();
      hasReport = hasReport || isReport;
      if (!isReport && held.count(name) == 0)
      {
        missing.push_back(PrintableText(name));
      }
    }
  }
  if (hasReport)
  {
    missing.emplace_back("the report");
  }
  return missing;
}

/// "cannot hold arrays (depth, Distance and the report); vtp and vtk can"
std::string ArrayLoss(vtkPolyData* surface, const SurfaceFormat& format, bool isDivided)
{
  const std::vector<std::string> missing = MissingArrays(surface, format);
  constexpr std::size_t mostNamed = 12;
  std::string names;
  for (std::size_t i = 0; i < std::min(missing.size(), mostNamed); ++i)
  {
    const bool isLast = i + 1 == missing.size();
    names += (i == 0 ? "" : isLast ? " and " : ", ") + missing[i];
  }
  if (missing.size() > mostNamed)
  {
    names += " and " + std::to_string(missing.size() - mostNamed) + " more";
  }
  const auto isMissing = [&missing](const char* name)
  { return std::find(missing.begin(), missing.end(), name) != missing.end(); };
  return missing.empty() ? std::string()
                         : "cannot hold arrays (" + names + "); " +
      ExtensionsThat(&SurfaceFormat::HoldsArrays) + " can" +
      (isMissing("SPACE") ? "; so the file does not say that its axes are " + FrameOf(surface)
                          : std::string()) +
      (isMissing(LabelsOfSidesName) && !isDivided
          ? "; walls between labels are inside the surface: a folder, or 3mf, has a closed surface "
            "for each label"
          : "");
}

std::string CellLoss(vtkPolyData* surface, const SurfaceFormat& format)
{
  const vtkIdType lines = surface->GetNumberOfLines();
  const vtkIdType vertices = surface->GetNumberOfVerts();
  if (format.HoldsArrays || format.HoldsLines || lines + vertices == 0)
  {
    return {};
  }
  return "cannot hold the " + (lines > 0 ? std::to_string(lines) + " lines" : std::string()) +
    (lines > 0 && vertices > 0 ? " and " : "") +
    (vertices > 0 ? std::to_string(vertices) + " vertices" : std::string()) + " of the surface";
}

/// Not every writer notices a full disk; what can be read back in full has arrived.
vtkSmartPointer<vtkPolyData> WriteAndCheck(
  vtkPolyData* surface, const std::string& path, bool isCompressed)
{
  TakeVtkMessages();
  const SurfaceFormat& format = *FindFormat(path);
  const bool canCompress = format.WriteCompressed != nullptr;
  (isCompressed && canCompress ? format.WriteCompressed : format.Write)(surface, path);
  const VtkMessages messages = TakeVtkMessages();
  if (!messages.Errors.empty())
  {
    throw Failure(ExitCode::CouldNotWrite, messages.Errors.front());
  }
  return Arrived(surface, path);
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
  loaded.Unit = TakeFileUnit(loaded.Surface);
  if (!loaded.Surface->GetPoints() || CountFaces(loaded.Surface) == 0)
  {
    Reject(path, "it holds no triangle");
  }
  return loaded;
}

vtkSmartPointer<vtkPolyData> WriteSurface(
  vtkPolyData* surface, const std::string& path, const std::string& target, bool isCompressed)
{
  try
  {
    return WriteAndCheck(surface, path, isCompressed);
  }
  catch (const Failure& failure)
  {
    throw Failure(failure.Code, "could not write '" + target + "': " + failure.what());
  }
}

std::string LossText(vtkPolyData* surface, const SurfaceFormat& format, bool isDivided)
{
  std::vector<std::string> losses = { ArrayLoss(surface, format, isDivided),
    CellLoss(surface, format) };
  if (!format.HoldsDoubles && surface->GetPoints()->GetDataType() == VTK_DOUBLE)
  {
    losses.emplace_back("rounds the double coordinates to single precision");
  }
  losses.push_back(format.IsForPrinting ? OpenPartsText(surface) : std::string());
  std::string text;
  for (const std::string& loss : losses)
  {
    text += (text.empty() || loss.empty() ? "" : ", and ") + loss;
  }
  return text.empty() ? text : format.Extension + (" " + text);
}
}
