// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CurrentFile.h"

#include "FilePath.h"

namespace bonedecimate::volume
{
namespace
{
std::string& Name()
{
  static std::string name;
  return name;
}
}

void ResetCurrentFile()
{
  Name().clear();
}

void SetCurrentFile(const std::string& path)
{
  Name() = FilePath(path).filename().string();
}

std::string CurrentFile()
{
  return Name();
}
}
