// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExitCode.h
 * @brief How the program ends, and the exception that carries a failure to its one catcher,
 * RunProgram().
 */
#ifndef BoneDecimate_Applications_ExitCode_h
#define BoneDecimate_Applications_ExitCode_h

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bonedecimate
{
enum class ExitCode : int
{
  Done = 0,
  Usage = 1,
  InputRejected = 2,
  CouldNotWrite = 3,
  Interrupted = 4,
  OutOfMemory = 5,
  Violated = 6, ///< As an end of a decimation: a defect.
  Undecided = 7,
  LeftOut = 8 ///< A batch left something out, and all else is done.
};

/// Every code with its meaning.
const std::vector<std::pair<ExitCode, std::string>>& ExitCodeMeanings();

/// The codes with a line on each, for --help.
std::string ExitCodesText();

class Failure : public std::runtime_error
{
public:
  Failure(ExitCode code, const std::string& message)
    : std::runtime_error(message)
    , Code(code)
  {
  }

  ExitCode Code;
};

/// Rejects a command line. @throws Failure(ExitCode::Usage) unless it is right.
void RequireUsage(bool isRight, const std::string& problem);
}

#endif
