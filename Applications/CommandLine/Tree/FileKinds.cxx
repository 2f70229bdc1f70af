// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tree/FileKinds.h"

#include "BoneVolume.h"
#include "Formats/SurfaceFormat.h"

#include <algorithm>
#include <functional>

namespace bonedecimate
{
namespace
{
using Extensions = std::vector<std::string>;

/// Extensions of the formats that this build reads and writes.
Extensions SurfacesOfBuild()
{
  Extensions extensions;
  for (const SurfaceFormat* format : SurfaceFormats())
  {
    if (format->MissingLibrary.empty())
    {
      extensions.emplace_back(format->Extension);
    }
  }
  return extensions;
}

Extensions SurfacesAndVolumes()
{
  Extensions extensions = SurfacesOfBuild();
  const Extensions volumes = VolumeExtensions();
  extensions.insert(extensions.end(), volumes.begin(), volumes.end());
  return extensions;
}

struct FileKind
{
  const char* ValueName;
  std::function<Extensions()> GetExtensions;
};

const std::vector<FileKind>& FileKinds()
{
  static const std::vector<FileKind> kinds = {
    { "FILES", SurfacesAndVolumes },
    { "SURFACES", SurfacesOfBuild },
    { "SURFACE", SurfacesOfBuild },
    { "NAME.EXT", SurfacesOfBuild },
    { "LABELMAP", VolumeExtensions },
    { "totalsegmentator|TABLE",
      [] {
        return Extensions{ "json", "tsv", "csv", "ctbl", "txt", "label" };
      } },
    { "THESIS", [] { return Extensions{ "obj" }; } },
    { "JSON", [] { return Extensions{ "json" }; } },
    { "HTML", [] { return Extensions{ "html" }; } },
    { "PNG", [] { return Extensions{ "png" }; } },
    { "SVG", [] { return Extensions{ "svg" }; } },
    { "CSV", [] { return Extensions{ "csv" }; } },
    { "TOML", [] { return Extensions{ "toml" }; } },
    { "LOG", [] { return Extensions(); } },
  };
  return kinds;
}
}

std::optional<std::vector<std::string>> ExtensionsOfValue(const std::string& valueName)
{
  const auto& kinds = FileKinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(),
    [&valueName](const FileKind& one) { return one.ValueName == valueName; });
  return kind == kinds.end() ? std::nullopt
                             : std::optional<std::vector<std::string>>(kind->GetExtensions());
}
}
