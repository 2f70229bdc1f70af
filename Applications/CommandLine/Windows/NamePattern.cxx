// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Batch/NamePattern.h"

#include "FilePath.h"

#include <windows.h>

#include <shlwapi.h>

namespace bonedecimate
{
bool MatchesPattern(const std::string& name, const std::string& pattern)
{
  return PathMatchSpecW(FilePath(name).c_str(), FilePath(pattern).c_str()) != 0;
}
}
