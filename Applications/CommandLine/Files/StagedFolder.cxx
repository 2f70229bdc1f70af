// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StagedFolder.h"

#include "ExitCode.h"
#include "FilePath.h"

#include <system_error>

namespace fs = std::filesystem;

namespace bonedecimate
{
StagedFolder::StagedFolder(const std::string& path)
{
  std::error_code error;
  fs::path part;
  for (const fs::path& name : FilePath(path))
  {
    part /= name;
    if (!error && !name.empty() && fs::create_directory(part, error))
    {
      this->Made.push_back(part);
    }
  }
  if (error)
  {
    this->Remove();
    throw Failure(ExitCode::CouldNotWrite, "could not make '" + path + "': " + error.message());
  }
}

StagedFolder::~StagedFolder()
{
  this->Remove();
}

void StagedFolder::Remove()
{
  std::error_code ignored;
  for (auto made = this->Made.rbegin(); made != this->Made.rend(); ++made)
  {
    fs::remove(*made, ignored); // a folder with files is not removed
  }
}
}
