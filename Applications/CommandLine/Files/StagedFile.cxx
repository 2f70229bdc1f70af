// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StagedFile.h"

#include "ExitCode.h"
#include "FileNames.h"
#include "FilePath.h"
#include "FolderEntries.h"
#include "StandardOutput.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <set>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
[[noreturn]] void Fail(const std::string& target, const std::string& reason)
{
  throw Failure(ExitCode::CouldNotWrite, "could not write '" + target + "': " + reason);
}

/// The file of a name; a link stays, the file that it points to is replaced.
fs::path ResolvedTarget(const std::string& target)
{
  std::error_code error;
  const fs::file_status status = fs::status(FilePath(target), error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    Fail(target, fs::is_directory(status) ? "it is a folder" : "it is not a regular file");
  }
  const fs::path resolved =
    fs::exists(status) ? fs::canonical(FilePath(target), error) : FilePath(target);
  return error ? FilePath(target) : resolved;
}

/// Permissions of a regular file; nothing if there is no such file.
std::optional<fs::perms> ModeOf(const std::string& file)
{
  std::error_code error;
  const fs::file_status status = fs::status(FilePath(file), error);
  return fs::is_regular_file(status) ? std::optional(status.permissions()) : std::nullopt;
}

constexpr const char* CommonPrefix = ".bonedecimate-";

/// ".bonedecimate-PROCESS-SYSTEM-", before a number and the target's extension.
std::string PrefixOf(int process)
{
  return CommonPrefix + std::to_string(process) + "-" + SystemName() + "-";
}

/// Whether the name is one that PrefixOf() begins, of any process of this system.
bool IsOfThisSystem(const std::string& name)
{
  const std::size_t begin = std::string(CommonPrefix).size();
  const std::size_t end = name.find('-', begin);
  return !SystemName().empty() && name.rfind(CommonPrefix, 0) == 0 && end != std::string::npos &&
    name.compare(end, SystemName().size() + 2, "-" + SystemName() + "-") == 0;
}

std::string TemporaryName(const fs::path& target, int attempt)
{
  // The leading dot keeps it out of a batch that reads the folder.
  std::string name = PrefixOf(getpid()) + std::to_string(attempt);
  name += target.has_extension() ? "." + ExtensionOf(target.string()) : "";
  return (target.parent_path() / FilePath(name)).string();
}

std::vector<fs::path> FilesIn(
  const std::string& folder, const std::function<bool(const std::string&)>& isSelected)
{
  std::error_code ignored;
  std::vector<fs::path> found = FolderEntries(FilePath(folder), ignored);
  found.erase(
    std::remove_if(found.begin(), found.end(),
      [&isSelected](const fs::path& path) { return !isSelected(path.filename().string()); }),
    found.end());
  return found;
}

/// Once for each folder that this process writes to.
void RemoveAbandonedFilesIn(const fs::path& folder)
{
  static std::set<std::string> known;
  const std::string name = folder.empty() ? "." : folder.string();
  if (known.insert(name).second)
  {
    for (const fs::path& path : FilesIn(name, IsOfThisSystem))
    {
      RemoveIfAbandoned(path.string());
    }
  }
}
}

StagedFile::StagedFile(const std::string& target)
  : Target(target)
  , Resolved(IsStandardOutput(target) ? std::string() : ResolvedTarget(target).string())
{
  if (IsStandardOutput(target))
  {
    return;
  }
  this->Mode = ModeOf(this->Resolved);
  RemoveAbandonedFilesIn(FilePath(this->Resolved).parent_path());
  for (int attempt = 0; this->Temporary.empty(); ++attempt)
  {
    const std::string name = TemporaryName(FilePath(this->Resolved), attempt);
    const FileLock::Outcome outcome = this->Lock.Make(name);
    if (outcome == FileLock::Outcome::Failed)
    {
      Fail(target, this->Lock.GetProblem());
    }
    this->Temporary = outcome == FileLock::Outcome::Made ? name : std::string();
  }
  if (this->Mode)
  {
    // Users that cannot read the file that is replaced cannot read the temporary one.
    std::error_code ignored;
    const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
    fs::permissions(FilePath(this->Temporary), *this->Mode | own, ignored);
  }
}

StagedFile::~StagedFile()
{
  std::error_code ignored;
  if (!this->Temporary.empty())
  {
    fs::remove(FilePath(this->Temporary), ignored);
  }
}

void StagedFile::WriteText(const std::string& text)
{
  if (IsStandardOutput(this->Target))
  {
    this->Text = text;
    return;
  }
  errno = 0;
  std::ofstream stream(this->Temporary, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream)
  {
    Fail(this->Target, errno ? std::strerror(errno) : "the system did not take the whole file");
  }
}

void StagedFile::Flush()
{
  const std::string problem =
    IsStandardOutput(this->Target) ? std::string() : FlushToDisk(this->Temporary);
  if (!problem.empty())
  {
    Fail(this->Target, problem);
  }
}

void StagedFile::Commit()
{
  if (IsStandardOutput(this->Target))
  {
    WriteToStandardOutput(this->Text);
    return;
  }
  std::error_code error;
  if (this->Mode)
  {
    fs::permissions(FilePath(this->Temporary), *this->Mode, error);
    error.clear(); // a file system without modes
  }
  fs::rename(FilePath(this->Temporary), FilePath(this->Resolved), error);
  if (error)
  {
    Fail(this->Target, error.message());
  }
  this->Temporary.clear();
}

void RemoveStagedFilesOf(int process, const std::string& folder)
{
  const std::string prefix = PrefixOf(process);
  std::error_code ignored;
  for (const fs::path& path :
    FilesIn(folder, [&](const std::string& name) { return name.rfind(prefix, 0) == 0; }))
  {
    fs::remove(path, ignored);
  }
}

void WriteTextFile(const std::string& target, const std::string& text)
{
  StagedFile file(target);
  file.WriteText(text);
  file.Flush();
  file.Commit();
}
}
