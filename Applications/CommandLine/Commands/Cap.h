// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Cap.h
 * @brief bonedecimate cap: closes open boundaries of a surface.
 */
#ifndef BoneDecimate_Applications_Cap_h
#define BoneDecimate_Applications_Cap_h

#include "Arguments/CliForward.h"
#include "Arguments/LengthUnit.h"

#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
struct CapArguments
{
  std::vector<std::string> Files;  ///< Input and output.
  std::string Loops = "planes";    ///< "planes" or "all".
  std::optional<double> Tolerance; ///< mm; empty: the filter's.
  std::string Json;                ///< A file; empty: none.
  LengthUnit Unit;                 ///< Unit of the coordinates in the files.
  bool Quiet = false;
};

/// Adds the command. It throws Failure and std::bad_alloc.
void AddCapCommand(CLI::App& program);
}

#endif
