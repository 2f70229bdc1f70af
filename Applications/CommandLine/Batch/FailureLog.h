// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FailureLog.h
 * @brief What a failed input printed, with a last line "INPUT: exit code N", from which the table
 * of a folder is made again.
 */
#ifndef BoneDecimate_Applications_FailureLog_h
#define BoneDecimate_Applications_FailureLog_h

#include "BatchTable.h"

#include <optional>
#include <string>

namespace bonedecimate
{
/// @param printed Everything that the input printed.
/// @throws Failure(ExitCode::CouldNotWrite)
void WriteFailureLog(
  const std::string& path, const std::string& printed, const std::string& input, ExitCode code);

/// The row of the input, without its name; none if the file is no such log.
std::optional<BatchRow> ReadFailureLog(const std::string& path);
}

#endif
