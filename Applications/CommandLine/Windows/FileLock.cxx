// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileLock.h"

#include "FilePath.h"

#include <io.h>
#include <system_error>
#include <windows.h>

namespace bonedecimate
{
namespace
{
// Others write to the file and rename it while there is a lock on it.
constexpr DWORD SharedByAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

HANDLE Open(const std::string& name, DWORD access, DWORD creation)
{
  return CreateFileW(
    FilePath(name).c_str(), access, SharedByAll, nullptr, creation, FILE_ATTRIBUTE_NORMAL, nullptr);
}

std::string ProblemOf(DWORD error)
{
  return std::system_category().message(static_cast<int>(error));
}

/// A byte far behind any end of a file: here a lock keeps others from reading and writing.
bool Lock(HANDLE file)
{
  OVERLAPPED range = {};
  range.OffsetHigh = 0x40000000;
  return LockFileEx(file, LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &range) !=
    0;
}
}

FileLock::~FileLock()
{
  if (this->File >= 0)
  {
    _close(this->File);
  }
}

FileLock::Outcome FileLock::Make(const std::string& name)
{
  const HANDLE file = Open(name, GENERIC_READ | GENERIC_WRITE, CREATE_NEW);
  if (file == INVALID_HANDLE_VALUE)
  {
    const DWORD error = GetLastError();
    this->Problem = ProblemOf(error);
    return error == ERROR_FILE_EXISTS ? Outcome::NameIsTaken : Outcome::Failed;
  }
  if (!Lock(file))
  {
    CloseHandle(file); // another process found the file before the lock, and removes it
    return Outcome::NameIsTaken;
  }
  this->File = _open_osfhandle(reinterpret_cast<intptr_t>(file), 0);
  return Outcome::Made;
}

void RemoveIfAbandoned(const std::string& name)
{
  const HANDLE file = Open(name, GENERIC_READ | GENERIC_WRITE, OPEN_EXISTING);
  if (file == INVALID_HANDLE_VALUE)
  {
    return;
  }
  if (Lock(file))
  {
    DeleteFileW(FilePath(name).c_str());
  }
  CloseHandle(file);
}

std::string FlushToDisk(const std::string& name)
{
  const HANDLE file = Open(name, GENERIC_WRITE, OPEN_EXISTING);
  if (file == INVALID_HANDLE_VALUE)
  {
    return ProblemOf(GetLastError());
  }
  const std::string problem = FlushFileBuffers(file) ? std::string() : ProblemOf(GetLastError());
  CloseHandle(file);
  return problem;
}

/// Locks hold on network drives, too: all such files are of one system.
const std::string& SystemName()
{
  static const std::string name = "windows";
  return name;
}
}
