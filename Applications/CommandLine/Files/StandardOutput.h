// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StandardOutput.h
 * @brief Text files whose name is "-": they go to the standard output, and what the program says
 * goes to the standard error.
 */
#ifndef BoneDecimate_Applications_StandardOutput_h
#define BoneDecimate_Applications_StandardOutput_h

#include <streambuf>
#include <string>
#include <vector>

namespace bonedecimate
{
/// "-" or "/dev/stdout".
bool IsStandardOutput(const std::string& name);

/// As long as it lives, std::cout says everything on the standard error if a word of the command
/// line names the standard output.
class StandardOutputForFile
{
public:
  /// @param words Without the name of the program.
  explicit StandardOutputForFile(const std::vector<std::string>& words);
  ~StandardOutputForFile();
  StandardOutputForFile(const StandardOutputForFile&) = delete;
  StandardOutputForFile& operator=(const StandardOutputForFile&) = delete;

private:
  std::streambuf* Output = nullptr; // null: not redirected
};

/// @throws Failure(ExitCode::CouldNotWrite)
void WriteToStandardOutput(const std::string& text);
}

#endif
