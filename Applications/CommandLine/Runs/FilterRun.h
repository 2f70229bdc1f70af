// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterRun.h
 * @brief The steps that every command has in common: read, run a filter, collect messages, print
 * warnings.
 */
#ifndef BoneDecimate_Applications_FilterRun_h
#define BoneDecimate_Applications_FilterRun_h

#include "Arguments/LengthUnit.h"
#include "Terminal/ProgressDisplay.h"
#include "Terminal/VtkMessages.h"

#include "vtkAlgorithm.h"

#include <functional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Checks the requested unit. @throws Failure(ExitCode::Usage) if the file names another one.
void RequireUnitOfFile(
  const MillimeterSurface& loaded, const std::string& path, const LengthUnit& unit);

/// Reads a surface and appends what the reader warns of. @throws Failure(ExitCode::InputRejected)
MillimeterSurface ReadInput(
  const std::string& path, const LengthUnit& unit, std::vector<std::string>& warnings);

/**
 * Updates a filter.
 * @param phase "simplifying": what the display calls it.
 * @returns The messages of VTK during the update.
 * @throws Failure(ExitCode::Interrupted)
 */
VtkMessages UpdateFilter(
  vtkAlgorithm* filter, Progress progress, const std::string& phase = "processing");

/// The same, but after an interruption, which aborts the filter, it returns.
/// @param detail What the display shows behind the fraction; may be empty.
VtkMessages UpdateUntilInterrupted(vtkAlgorithm* filter, Progress progress,
  const std::string& phase, const std::function<std::string()>& detail = {});

/**
 * Appends the warnings.
 * @param source The file to name if there is an error.
 * @param unit The requested one of its coordinates.
 * @throws Failure(ExitCode::InputRejected) with the first error.
 */
void AcceptMessages(const VtkMessages& messages, const std::string& source,
  std::vector<std::string>& warnings, const LengthUnit& unit = {});

void PrintWarnings(const std::vector<std::string>& warnings);
}

#endif
