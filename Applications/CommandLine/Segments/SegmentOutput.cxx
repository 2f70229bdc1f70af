// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentOutput.h"

#include "Base/Text.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "Picture.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace fs = std::filesystem;

namespace bonedecimate
{
bool IsBlockFile(const std::string& output)
{
  return output.back() != '/' && ExtensionOf(output) == "vtm";
}

bool IsSegmentFolder(const Arguments& arguments)
{
  return arguments.Segments.IsRequested() && !IsBlockFile(arguments.Output) &&
    FindFormat(arguments.Output) == nullptr;
}

bool WritesSegments(const Arguments& arguments)
{
  return arguments.Segments.IsRequested() && FindFormat(arguments.Output) == nullptr;
}

std::string FolderOfSegments(const Arguments& arguments)
{
  const fs::path output = FilePath(arguments.Output);
  return IsBlockFile(arguments.Output) ? (output.parent_path() / output.stem()).string()
                                       : output.string();
}

std::string ExtensionOfSegments(const Arguments& arguments)
{
  return arguments.Format.empty() ? "vtp" : LowerCase(arguments.Format);
}

std::vector<const SurfaceFormat*> FormatsOfSurfaces(const Arguments& arguments)
{
  std::vector<const SurfaceFormat*> formats = { FindFormat(
    WritesSegments(arguments) ? "x." + ExtensionOfSegments(arguments) : arguments.Output) };
  std::transform(
    arguments.Also.begin(), arguments.Also.end(), std::back_inserter(formats), FindFormat);
  return formats;
}

void NameFilesOfFolder(Arguments& arguments)
{
  if (arguments.Output.empty() || IsBatch(arguments) || !IsSegmentFolder(arguments))
  {
    return;
  }
  const fs::path folder = FilePath(arguments.Output);
  const auto name = [&folder](std::string& file, const char* own)
  { file = file.empty() ? (folder / own).string() : file; };
  name(arguments.Report, "report.json");
  if (arguments.Memory > 0)
  {
    return; // neither page nor picture of surfaces that may be larger than memory
  }
  name(arguments.Page, "index.html");
  arguments.PictureIsRequired = !arguments.Picture.empty();
  if (WhyNoPictures().empty())
  {
    name(arguments.Picture, "picture.png");
  }
}
}
