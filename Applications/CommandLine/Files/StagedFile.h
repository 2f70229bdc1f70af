// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StagedFile.h
 * @brief A file that appears under its name whole or not at all.
 */
#ifndef BoneDecimate_Applications_StagedFile_h
#define BoneDecimate_Applications_StagedFile_h

#include "FileLock.h"

#include <filesystem>
#include <optional>
#include <string>

namespace bonedecimate
{
/**
 * Reserves a temporary file in the target's folder, with the target's extension, and renames it
 * when all is well. A file that is replaced keeps its mode. Without Commit() the temporary file is
 * removed. Every method throws Failure(ExitCode::CouldNotWrite).
 *
 * Text of which the target is the standard output ("-") is written there by Commit().
 *
 * A process that is killed leaves its temporary file behind. The next that writes to the folder
 * removes it: as long as a process lives it holds a lock (FileLock) on each of its files, and the
 * name tells on which running system, so that files of another computer that uses the folder are
 * left alone.
 */
class StagedFile
{
public:
  explicit StagedFile(const std::string& target);
  ~StagedFile();
  StagedFile(const StagedFile&) = delete;
  void operator=(const StagedFile&) = delete;

  const std::string& GetTarget() const { return this->Target; }
  const std::string& GetTemporary() const { return this->Temporary; }

  /// Replaces the temporary file's content.
  void WriteText(const std::string& text);

  /// Waits until the system has accepted every byte: some file systems tell only now that the disk
  /// is full.
  void Flush();

  void Commit();

private:
  std::string Target;
  std::string Resolved;                       // Target without symbolic links
  std::string Temporary;                      // empty once committed
  std::optional<std::filesystem::perms> Mode; // of the file that is replaced
  FileLock Lock;
  std::string Text; // for the standard output
};

/// Removes what a process that died left of its own in a folder.
void RemoveStagedFilesOf(int process, const std::string& folder);

/// Writes a text file whole or not at all.
void WriteTextFile(const std::string& target, const std::string& text);
}

#endif
