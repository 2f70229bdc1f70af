// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchTable.h
 * @brief What became of every bone of a batch: summary.csv for programs, a table for people.
 */
#ifndef BoneDecimate_Applications_BatchTable_h
#define BoneDecimate_Applications_BatchTable_h

#include "ExitCode.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct BatchRow
{
  std::string Name;
  std::string Input;              ///< Base name.
  std::string Status = "not run"; ///< Or "done", "skipped", "failed", "interrupted".
  ExitCode Code = ExitCode::Interrupted;
  std::string Report;  ///< File to take the numbers from; read if the status is done or skipped.
  std::string Message; ///< Why it failed or was skipped.
};

std::string ComposeCsv(const std::vector<BatchRow>& rows);

void PrintTable(const std::vector<BatchRow>& rows);
}

#endif
