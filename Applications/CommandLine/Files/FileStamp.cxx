// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileStamp.h"

#include "Base/Text.h"
#include "FilePath.h"
#include "FolderEntries.h"
#include "Formats/LineReader.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
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

/// The file that has the voxels of a header of MetaImage or NRRD; empty if it is no such header.
std::string DataFileOf(const std::string& header)
{
  const std::string extension = LowerCase(FilePath(header).extension().string());
  const bool isMetaImage = extension == ".mhd";
  std::ifstream file(isMetaImage || extension == ".nhdr" ? FilePath(header) : fs::path());
  std::string line;
  constexpr int mostLines = 1000;
  for (int i = 0; i < mostLines && std::getline(file, line); ++i)
  {
    const std::size_t separator = line.find(isMetaImage ? '=' : ':');
    const std::string key = LowerCase(std::string(Trimmed(line.substr(0, separator))));
    if (separator != std::string::npos &&
      (key == "elementdatafile" || key == "data file" || key == "datafile"))
    {
      const std::string name(Trimmed(line.substr(separator + 1)));
      return (FilePath(header).parent_path() / FilePath(name)).string();
    }
  }
  return {};
}

void Add(const FileStamp& file, FileStamp& sum)
{
  sum.Bytes += file.Bytes;
  sum.Modified = std::max(sum.Modified, file.Modified);
}
}

FileStamp StampOf(const std::string& path)
{
  std::error_code error;
  if (!fs::is_directory(FilePath(path), error))
  {
    FileStamp stamp = StampOfFile(path);
    if (const std::string data = DataFileOf(path); fs::is_regular_file(FilePath(data), error))
    {
      Add(StampOfFile(data), stamp);
    }
    return stamp;
  }
  FileStamp stamp;
  for (const fs::path& entry : FolderEntries(FilePath(path), error))
  {
    Add(StampOfFile(entry.string()), stamp);
  }
  return stamp;
}
}
