// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Diagnose.h
 * @brief bonedecimate diagnose: what is unusual about a surface.
 */
#ifndef BoneDecimate_Applications_Diagnose_h
#define BoneDecimate_Applications_Diagnose_h

#include "Arguments/CliForward.h"
#include "Arguments/LengthUnit.h"
#include "ExitCode.h"
#include "Settings/SettingsRecord.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct DiagnoseArguments
{
  std::vector<std::string> Files; ///< The one input.
  std::string Json;               ///< A file; empty: none.
  int Threads = 0;
  LengthUnit Unit; ///< Unit of the coordinates in the file.
  SettingsRecord Settings;
  bool Quiet = false;
};

/**
 * Adds the command. Its code is Done if decimation accepts the surface, InputRejected if not.
 * It throws Failure and std::bad_alloc.
 */
void AddDiagnoseCommand(CLI::App& program, ExitCode& code);
}

#endif
