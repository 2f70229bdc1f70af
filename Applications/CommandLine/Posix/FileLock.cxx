// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileLock.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bonedecimate
{
namespace
{
/// Whether the name still is that of the open file.
bool IsNameOf(const std::string& name, int file)
{
  struct stat named = {};
  struct stat opened = {};
  return lstat(name.c_str(), &named) == 0 && fstat(file, &opened) == 0 &&
    named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}
}

FileLock::~FileLock()
{
  if (this->File >= 0)
  {
    close(this->File);
  }
}

FileLock::Outcome FileLock::Make(const std::string& name)
{
  this->File = open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (this->File < 0)
  {
    const int reason = errno;
    this->Problem = std::strerror(reason);
    return reason == EEXIST ? Outcome::NameIsTaken : Outcome::Failed;
  }
  // Another process may take the file for abandoned before the lock; it removes it with the lock
  // held, and is gone when this one has it. A file system without locks removes nothing.
  while (flock(this->File, LOCK_EX) != 0 && errno == EINTR)
  {
  }
  if (!IsNameOf(name, this->File))
  {
    close(this->File);
    this->File = -1;
    return Outcome::NameIsTaken;
  }
  return Outcome::Made;
}

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
  // The lock is held while the name is removed: see FileLock::Make().
  if (isFile && flock(file, LOCK_EX | LOCK_NB) == 0 && IsNameOf(name, file))
  {
    unlink(name.c_str());
  }
  close(file);
}

std::string FlushToDisk(const std::string& name)
{
  const int file = open(name.c_str(), O_RDONLY | O_CLOEXEC);
  const std::string problem =
    file >= 0 && fsync(file) == 0 ? std::string() : std::string(std::strerror(errno));
  if (file >= 0)
  {
    close(file);
  }
  return problem;
}

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
}
