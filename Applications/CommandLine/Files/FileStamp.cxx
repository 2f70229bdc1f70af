// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileStamp.h"

#include "FilePath.h"
#include "FolderEntries.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <system_error>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
/// Seconds from 1970 to the origin of the times of files, which is the library's own: a whole
/// number.
std::chrono::seconds OriginOfFileTimes()
{
  static const auto origin =
    std::chrono::round<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch() -
      fs::file_time_type::clock::now().time_since_epoch());
  return origin;
}

FileStamp StampOfFile(const std::string& path)
{
  std::error_code error;
  const auto bytes = fs::file_size(FilePath(path), error);
  const fs::file_time_type modified =
    error ? fs::file_time_type() : fs::last_write_time(FilePath(path), error);
  if (error)
  {
    return {};
  }
  const auto since =
    std::chrono::duration_cast<std::chrono::nanoseconds>(modified.time_since_epoch()) +
    OriginOfFileTimes();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(since);
  const auto time = static_cast<std::time_t>(seconds.count());
  char day[40];
  std::strftime(day, sizeof(day), "%Y-%m-%dT%H:%M:%S", std::gmtime(&time));
  char fraction[20];
  std::snprintf(
    fraction, sizeof(fraction), ".%09lldZ", static_cast<long long>((since - seconds).count()));
  return { static_cast<std::int64_t>(bytes), std::string(day) + fraction };
}
}

FileStamp StampOf(const std::string& path)
{
  std::error_code error;
  if (!fs::is_directory(FilePath(path), error))
  {
    return StampOfFile(path);
  }
  FileStamp stamp;
  for (const fs::path& entry : FolderEntries(FilePath(path), error))
  {
    const FileStamp file = StampOfFile(entry.string());
    stamp.Bytes += file.Bytes;
    stamp.Modified = std::max(stamp.Modified, file.Modified);
  }
  return stamp;
}
}
