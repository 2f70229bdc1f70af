// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FolderEntries.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace bonedecimate
{
std::vector<fs::path> FolderEntries(const fs::path& folder, std::error_code& error)
{
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
  {
    entries.push_back(entry->path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}
}
