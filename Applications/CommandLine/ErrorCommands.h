// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorCommands.h
 * @brief bonedecimate tolerance: the smallest error that can be proved for a number of triangles; bonedecimate curve: the
 * number of triangles for each of some errors.
 */
#ifndef BoneDecimate_Applications_ErrorCommands_h
#define BoneDecimate_Applications_ErrorCommands_h

#include "ExitCode.h"
#include "LengthUnit.h"

#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
struct ErrorArguments
{
  std::string Input;
  int Triangles = 0;          ///< tolerance only
  double Precision = 0.02;    ///< tolerance only
  std::vector<double> Errors; ///< mm, curve only
  std::string Mode = "Balanced";
  int Threads = 0;
  bool AllowLargeError = false; ///< curve only
  LengthUnit Unit;              ///< Of the coordinates in the file.
  std::string Json;             ///< Files; empty: none.
  std::string Csv;
  std::string Picture;
  bool Quiet = false;
};

/// @param argc The word argv[1] is "tolerance" or "curve".
/// @returns Nothing if it asked for a text (--help), which is then printed.
/// @throws Failure(ExitCode::Usage)
std::optional<ErrorArguments> ParseErrorArguments(int argc, char* argv[]);

/**
 * @returns Done, or Violated if no run was as small as asked for.
 * @throws Failure, std::bad_alloc
 */
ExitCode RunErrorCommand(const ErrorArguments& arguments);
}

#endif
