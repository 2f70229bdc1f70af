// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFormat.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace bonedecimate
{
const char* const SurfaceExtensions = "obj, stl, ply, vtp, vtk";

std::string LowerText(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

std::string ExtensionOf(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  extension.erase(0, 1);
  return LowerText(extension);
}

SurfaceFormat FormatOf(const std::string& path)
{
  static const std::map<std::string, SurfaceFormat> formats = {
    { "obj", SurfaceFormat::Obj },
    { "stl", SurfaceFormat::Stl },
    { "ply", SurfaceFormat::Ply },
    { "vtp", SurfaceFormat::Vtp },
    { "vtk", SurfaceFormat::Vtk },
  };
  const auto format = formats.find(ExtensionOf(path));
  return format == formats.end() ? SurfaceFormat::Unknown : format->second;
}

bool HoldsArrays(SurfaceFormat format)
{
  return format == SurfaceFormat::Vtp || format == SurfaceFormat::Vtk;
}

bool HoldsDoubles(SurfaceFormat format)
{
  return format != SurfaceFormat::Stl;
}

std::string BaseName(const std::string& path)
{
  const std::filesystem::path whole(path);
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}
}
