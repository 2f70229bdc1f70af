// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorCommands.h
 * @brief bonedecimate tolerance: the smallest error that can be proved for a number of triangles;
 * bonedecimate curve: the number of triangles for each of some errors.
 */
#ifndef BoneDecimate_Applications_ErrorCommands_h
#define BoneDecimate_Applications_ErrorCommands_h

#include "Arguments/CliForward.h"
#include "Arguments/CommonOptions.h"
#include "Arguments/InputArguments.h"
#include "Arguments/LabelMapArguments.h"
#include "Arguments/LengthUnit.h"
#include "ExitCode.h"
#include "Settings/SettingsRecord.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct ErrorArguments
{
  std::vector<std::string> Files; ///< One.
  int Triangles = 0;              ///< tolerance only
  double Precision = 0.02;        ///< tolerance only
  std::vector<double> Errors;     ///< mm, curve only
  std::string Mode = DefaultMode();
  int Threads = 0;
  bool AllowLargeError = false; ///< curve only
  VoxelArguments Voxels;
  InputArguments Input;
  LengthUnit Unit;  ///< Unit of the coordinates in the file.
  std::string Json; ///< Files; empty: none.
  std::string Csv;
  std::string Picture;
  SettingsRecord Settings;
  bool Quiet = false;
};

/**
 * @name Add the commands. Their code is Done, or Violated if no run has as few triangles as
 * requested. They throw Failure and std::bad_alloc.
 * @{
 */
void AddToleranceCommand(CLI::App& program, ExitCode& code);
void AddCurveCommand(CLI::App& program, ExitCode& code);
/// @}
}

#endif
