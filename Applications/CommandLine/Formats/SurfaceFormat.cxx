// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SurfaceFormat.h"

#include "ExitCode.h"
#include "Files/FileNames.h"

#include <algorithm>

namespace bonedecimate
{
extern const SurfaceFormat VtpFormat, VtkFormat, PlyFormat, StlFormat, ObjFormat, GlbFormat,
  ThreeMfFormat;

const std::vector<const SurfaceFormat*>& SurfaceFormats()
{
  static const std::vector<const SurfaceFormat*> formats = { &VtpFormat, &VtkFormat, &PlyFormat,
    &StlFormat, &ObjFormat, &GlbFormat, &ThreeMfFormat };
  return formats;
}

SurfaceFormat FormatWithoutLibrary(const char* extension, const char* library)
{
  const auto read = [](const std::string& path,
                      std::vector<std::string>&) -> vtkSmartPointer<vtkPolyData>
  { throw Failure(ExitCode::InputRejected, LackText(path)); };
  const auto write = [](vtkPolyData*, const std::string& path)
  { throw Failure(ExitCode::CouldNotWrite, LackText(path)); };
  SurfaceFormat format = { extension, false, true, false, read, write };
  format.MissingLibrary = library;
  return format;
}

std::string LackText(const std::string& path)
{
  const SurfaceFormat* const format = FindFormat(path);
  return format == nullptr || format->MissingLibrary.empty()
    ? std::string()
    : "'" + path + "' needs " + format->MissingLibrary + ", which this build lacks";
}

const SurfaceFormat* FindFormat(const std::string& path)
{
  const std::string extension = ExtensionOf(path);
  const auto& formats = SurfaceFormats();
  const auto found = std::find_if(formats.begin(), formats.end(),
    [&extension](const SurfaceFormat* format) { return format->Extension == extension; });
  return found == formats.end() ? nullptr : *found;
}

std::string SurfaceExtensions()
{
  std::string text;
  for (const SurfaceFormat* format : SurfaceFormats())
  {
    text += (text.empty() ? "" : ", ") + std::string(format->Extension);
  }
  return text;
}

std::string ExtensionsThat(bool SurfaceFormat::*property)
{
  std::vector<std::string> names;
  for (const SurfaceFormat* format : SurfaceFormats())
  {
    if (format->*property)
    {
      names.emplace_back(format->Extension);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  }
  return text;
}
}
