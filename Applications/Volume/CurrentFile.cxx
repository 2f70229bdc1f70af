// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CurrentFile.h"

#include "FilePath.h"

namespace bonedecimate::volume
{
std::string DamagedFileProblem(const std::string& path)
{
  return "its file " + FilePath(path).filename().string() +
    " is damaged or truncated: copy it again, or move it to another folder to go on without it";
}
}
