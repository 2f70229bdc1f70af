// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileLock.h
 * @brief What a StagedFile needs of the operating system.
 */
#ifndef BoneDecimate_Applications_FileLock_h
#define BoneDecimate_Applications_FileLock_h

#include <string>

namespace bonedecimate
{
/// A new file, with a lock on it that the system takes back when the process ends, however it ends.
class FileLock
{
public:
  FileLock() = default;
  ~FileLock();
  FileLock(const FileLock&) = delete;
  void operator=(const FileLock&) = delete;

  enum class Outcome
  {
    Made,
    NameIsTaken,
    Failed
  };

  Outcome Make(const std::string& name);

  /// Why it failed.
  const std::string& GetProblem() const { return this->Problem; }

private:
  int File = -1;
  std::string Problem;
};

/// Removes a file that no living process has a lock on.
void RemoveIfAbandoned(const std::string& name);

/// Waits until the system has accepted every byte. Returns what went wrong, or an empty text.
std::string FlushToDisk(const std::string& name);

/// Name of the running system: files of other systems may lie in the same folder, and their locks
/// mean nothing here. Empty if the name is not known.
const std::string& SystemName();
}

#endif
