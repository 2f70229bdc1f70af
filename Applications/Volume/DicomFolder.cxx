// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFolder.h"

#include "FilePath.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace bonedecimate::volume
{
namespace
{
namespace fs = std::filesystem;

bool IsDicomEntry(const fs::directory_entry& entry)
{
  return IsDicomFile(entry.path().string());
}
}

bool IsDicomFile(const std::string& path)
{
  std::error_code error;
  if (!fs::is_regular_file(FilePath(path), error))
  {
    return false;
  }
  char beginning[132] = {};
  std::ifstream file(path, std::ios::binary);
  file.read(beginning, sizeof(beginning));
  return std::memcmp(beginning + 128, "DICM", 4) == 0;
}

std::vector<std::string> DicomFiles(const std::string& folder)
{
  std::vector<std::string> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(FilePath(folder), error))
  {
    if (IsDicomEntry(entry))
    {
      files.push_back(entry.path().string());
    }
  }
  // The system lists files in any order.
  std::sort(files.begin(), files.end());
  return files;
}

bool HoldsDicom(const std::string& folder)
{
  std::error_code error;
  const fs::directory_iterator entries(FilePath(folder), error);
  return std::any_of(begin(entries), end(entries), IsDicomEntry);
}
}
