// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FolderTable.h
 * @brief summary.csv of the output folder while a batch runs.
 */
#ifndef BoneDecimate_Applications_FolderTable_h
#define BoneDecimate_Applications_FolderTable_h

#include "BatchPlan.h"
#include "BatchTable.h"

#include <string>
#include <vector>

namespace bonedecimate
{
class FolderTable
{
public:
  /// Results in the folder that have other names than those of the batch keep their rows, unless
  /// the batch makes a result of the same input.
  FolderTable(const std::string& folder, const std::vector<BatchBone>& bones);

  /// A full disk does not end the batch before its inputs: it is a problem, until the next time.
  void Write(const std::vector<BatchRow>& rows);

  bool HasProblem() const { return !this->Problem.empty(); }

  /// @throws Failure(ExitCode::CouldNotWrite) if it could not be written the last time.
  void Require() const;

  /// Where it is.
  const std::string& Path() const { return this->File; }

private:
  std::string Folder;
  std::vector<BatchRow> Others;
  std::string File;
  std::string Problem;
};
}

#endif
