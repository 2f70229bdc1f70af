// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileNames.h"

#include "Base/Text.h"
#include "FilePath.h"

#include <filesystem>

namespace bonedecimate
{
std::string ExtensionOf(const std::string& path)
{
  std::string extension = FilePath(path).extension().string();
  extension.erase(0, 1);
  return LowerCase(extension);
}

std::string BaseName(const std::string& path)
{
  const std::filesystem::path whole = FilePath(path);
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}
}
