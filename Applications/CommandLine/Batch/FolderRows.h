// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FolderRows.h
 * @brief The table of a folder of results from the reports in it and the logs of failed inputs.
 */
#ifndef BoneDecimate_Applications_FolderRows_h
#define BoneDecimate_Applications_FolderRows_h

#include "BatchTable.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// Also of the folders below. A report that cannot be read, and a surface that is missing or of
/// another size than its report says, is failed.
/// @throws Failure(ExitCode::InputRejected) if a folder cannot be read.
std::vector<BatchRow> RowsOfFolder(const std::string& folder);
}

#endif
