// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StagedFile.h"

#include "ExitCode.h"
#include "FileNames.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
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
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    Fail(target, fs::is_directory(status) ? "it is a folder" : "it is not a regular file");
  }
  const fs::path resolved = fs::exists(status) ? fs::canonical(target, error) : fs::path(target);
  return error ? fs::path(target) : resolved;
}

constexpr const char* CommonPrefix = ".bonedecimate-";

/// Of the running system: only files of processes of the same kernel have locks that can be trusted
/// here. The folder may be on a network. Empty where the system does not tell.
const std::string& SystemName()
{
  static const std::string name = []
  {
    std::string id;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
    id.erase(std::remove(id.begin(), id.end(), '-'), id.end());
    return id.substr(0, 12);
  }();
  return name;
}

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
  fs::path name = PrefixOf(getpid()) + std::to_string(attempt);
  name += target.has_extension() ? "." + ExtensionOf(target.string()) : "";
  return (target.parent_path() / name).string();
}

/// Whether the name still is that of the open file.
bool IsNameOf(const std::string& name, int file)
{
  struct stat named = {};
  struct stat opened = {};
  return lstat(name.c_str(), &named) == 0 && fstat(file, &opened) == 0 &&
    named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

/// A running process holds a lock on its files: a file that can be locked belongs to none.
void RemoveIfAbandoned(const std::string& name)
{
  // For writing, without which network file systems give no lock.
  const int file = open(name.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0)
  {
    return;
  }
  struct stat status = {};
  const bool isFile = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  // The lock is held while the name is removed: see Reserve().
  if (isFile && flock(file, LOCK_EX | LOCK_NB) == 0 && IsNameOf(name, file))
  {
    unlink(name.c_str());
  }
  close(file);
}

std::vector<fs::path> FilesIn(
  const std::string& folder, const std::function<bool(const std::string&)>& isSelected)
{
  std::vector<fs::path> found;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
  {
    if (isSelected(entry.path().filename().string()))
    {
      found.push_back(entry.path());
    }
  }
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

/// A new file with a lock on it; -1 and errno if there cannot be one, EEXIST if the name is taken.
int Reserve(const std::string& name)
{
  const int file = open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0)
  {
    return file;
  }
  // Another process may take the file for abandoned before the lock; it removes it with the lock
  // held, and is gone when this one has it. A file system without locks removes nothing.
  while (flock(file, LOCK_EX) != 0 && errno == EINTR)
  {
  }
  if (!IsNameOf(name, file))
  {
    close(file);
    errno = EEXIST;
    return -1;
  }
  return file;
}
}

StagedFile::StagedFile(const std::string& target)
  : Target(target)
  , Resolved(ResolvedTarget(target).string())
{
  RemoveAbandonedFilesIn(fs::path(this->Resolved).parent_path());
  for (int attempt = 0; this->Temporary.empty(); ++attempt)
  {
    const std::string name = TemporaryName(this->Resolved, attempt);
    this->Lock = Reserve(name);
    if (this->Lock >= 0)
    {
      this->Temporary = name;
    }
    else if (errno != EEXIST)
    {
      Fail(target, std::strerror(errno));
    }
  }
}

StagedFile::~StagedFile()
{
  std::error_code ignored;
  if (!this->Temporary.empty())
  {
    fs::remove(this->Temporary, ignored);
  }
  if (this->Lock >= 0)
  {
    close(this->Lock);
  }
}

void StagedFile::WriteText(const std::string& text)
{
  std::ofstream stream(this->Temporary, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream)
  {
    Fail(this->Target, errno ? std::strerror(errno) : "the disk may be full");
  }
}

void StagedFile::Flush()
{
  const int file = open(this->Temporary.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = file >= 0 && fsync(file) == 0;
  const int reason = errno;
  if (file >= 0)
  {
    close(file);
  }
  if (!flushed)
  {
    Fail(this->Target, std::strerror(reason));
  }
}

void StagedFile::Commit()
{
  std::error_code error;
  fs::rename(this->Temporary, this->Resolved, error);
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
