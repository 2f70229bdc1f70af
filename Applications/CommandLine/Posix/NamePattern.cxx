// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Batch/NamePattern.h"

#include <fnmatch.h>

namespace bonedecimate
{
bool MatchesPattern(const std::string& name, const std::string& pattern)
{
  return fnmatch(pattern.c_str(), name.c_str(), FNM_CASEFOLD) == 0;
}
}
