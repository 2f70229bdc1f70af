// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Inspect.h
 * @brief bonedecimate check: reads a surface and tells what is odd about it.
 */
#ifndef BoneDecimate_Applications_Inspect_h
#define BoneDecimate_Applications_Inspect_h

#include "ExitCode.h"
#include "LengthUnit.h"

#include <optional>
#include <string>

namespace bonedecimate
{
struct InspectArguments
{
  std::string File;
  std::string Json; ///< A file; empty: none.
  int Threads = 0;
  LengthUnit Unit; ///< Of the coordinates in the file.
  bool Quiet = false;
};

/// @returns Nothing if it asked for a text (--help), which is then printed.
/// @throws Failure(ExitCode::Usage)
std::optional<InspectArguments> ParseInspectArguments(int argc, char* argv[]);

/**
 * @returns Done if decimation takes the surface, InputRefused if not.
 * @throws Failure, std::bad_alloc
 */
ExitCode RunInspect(const InspectArguments& arguments);
}

#endif
