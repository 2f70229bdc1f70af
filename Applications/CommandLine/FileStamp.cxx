// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileStamp.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <sys/stat.h>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
FileStamp StampOfFile(const std::string& path)
{
  struct stat found = {};
  if (stat(path.c_str(), &found) != 0)
  {
    return {};
  }
  std::tm utc = {};
  gmtime_r(&found.st_mtim.tv_sec, &utc);
  char day[40];
  std::strftime(day, sizeof(day), "%Y-%m-%dT%H:%M:%S", &utc);
  char fraction[20];
  std::snprintf(fraction, sizeof(fraction), ".%09ldZ", static_cast<long>(found.st_mtim.tv_nsec));
  return { static_cast<std::int64_t>(found.st_size), std::string(day) + fraction };
}
}

FileStamp StampOf(const std::string& path)
{
  std::error_code error;
  if (!fs::is_directory(path, error))
  {
    return StampOfFile(path);
  }
  FileStamp stamp;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, error))
  {
    const FileStamp file = StampOfFile(entry.path().string());
    stamp.Bytes += file.Bytes;
    stamp.Modified = std::max(stamp.Modified, file.Modified);
  }
  return stamp;
}
}
