// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NamePattern.h"

#include <filesystem>
#include <windows.h>

#include <shlwapi.h>

namespace bonedecimate
{
bool MatchesPattern(const std::string& name, const std::string& pattern)
{
  return PathMatchSpecW(
           std::filesystem::path(name).c_str(), std::filesystem::path(pattern).c_str()) != 0;
}
}
