// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StagedFolder.h
 * @brief A folder that is made before its files, and goes again if none of them stays.
 */
#ifndef BoneDecimate_Applications_StagedFolder_h
#define BoneDecimate_Applications_StagedFolder_h

#include <filesystem>
#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * Makes a folder and those above it that are missing. In the end it removes those that it made and
 * that are empty: a StagedFile in it has to end first.
 */
class StagedFolder
{
public:
  /// @throws Failure(ExitCode::CouldNotWrite)
  explicit StagedFolder(const std::string& path);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  void operator=(const StagedFolder&) = delete;

  /// Nothing is removed in the end.
  void Keep() { this->Made.clear(); }

private:
  void Remove();

  std::vector<std::filesystem::path> Made; // the outermost first
};
}

#endif
