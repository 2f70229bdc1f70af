// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelsCommand.h
 * @brief bonedecimate levels: records a run or takes its log from a file, lists the levels that
 * were measured, writes those that are requested.
 */
#ifndef BoneDecimate_Applications_LevelsCommand_h
#define BoneDecimate_Applications_LevelsCommand_h

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
struct LevelsArguments
{
  std::vector<std::string> Files; ///< One.
  std::string Log;                ///< A log instead of a run.

  /// @name A run. @{
  int Coarsest = 0;
  std::string Mode = DefaultMode();
  double MaximumError = 0.0; ///< mm
  bool AllowLargeError = false;
  bool WithoutErrors = false;
  VoxelArguments Voxels;
  InputArguments Input; ///< Labels also with a log.
  std::string Record;   ///< Where its log goes; empty: nowhere.
  /// @}

  /// @name Levels. @{
  std::vector<int> Triangles;
  std::vector<double> Errors; ///< mm
  std::string Output;         ///< NAME.EXT; a level goes to NAME-TRIANGLES.EXT.
  bool CompressesGlb = false; ///< Outputs in glb.
  std::string Page;           ///< An HTML page of all measured levels; empty: none.
  std::string On;             ///< A surface with the same triangles; empty: the input.
  /// @}

  int Threads = 0;
  LengthUnit Unit; ///< Unit of coordinates in files of surfaces; a log is in millimeters.
  SettingsRecord Settings;
  bool Quiet = false;
};

/// Adds the command; its code is Done. It throws Failure and std::bad_alloc.
void AddLevelsCommand(CLI::App& program);

/// Requires that the outputs, with the file of a level if it has a name, differ and are no surfaces
/// that are read.
/// @throws Failure(ExitCode::Usage)
void KeepSurfaces(const LevelsArguments& arguments, const std::string& level);

/// @throws Failure, std::bad_alloc
void RunLevels(const LevelsArguments& arguments);
}

#endif
