// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFolder.h"

#include "FilePath.h"
#include "FolderEntries.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace bonedecimate::volume
{
namespace fs = std::filesystem;

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
  for (const fs::path& path : FolderEntries(FilePath(folder), error))
  {
    if (IsDicomFile(path.string()))
    {
      files.push_back(path.string());
    }
  }
  return files;
}

std::vector<std::string> DicomFilesBelow(const std::string& folder, std::size_t most)
{
  constexpr int deepest = 8;
  std::vector<std::string> files;
  std::error_code error;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator entry(FilePath(folder), options, error);
       !error && entry != fs::recursive_directory_iterator() && files.size() < most;
       entry.increment(error))
  {
    if (entry.depth() >= deepest)
    {
      entry.disable_recursion_pending();
    }
    if (IsDicomFile(entry->path().string()))
    {
      files.push_back(entry->path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool HoldsDicom(const std::string& folder)
{
  std::error_code error;
  const std::vector<fs::path> entries = FolderEntries(FilePath(folder), error);
  return std::any_of(entries.begin(), entries.end(),
    [](const fs::path& path) { return IsDicomFile(path.string()); });
}
}
