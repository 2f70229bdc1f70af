// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentArguments.h
 * @brief A label map as the input of a decimation: which of its segments, and what they are called.
 */
#ifndef BoneDecimate_Applications_SegmentArguments_h
#define BoneDecimate_Applications_SegmentArguments_h

#include "CliForward.h"

#include <functional>
#include <string>

namespace bonedecimate
{
struct SegmentArguments
{
  std::string Choice; ///< See ChooseSegments(); empty: the input is no label map.
  bool HasTotalSegmentatorNames = false; ///< Otherwise names are those of the map.

  bool IsRequested() const { return !this->Choice.empty(); }
};

/// Adds --segments and --label-names. @param given Receives flag without dashes and text.
void AddSegments(CLI::App& app, SegmentArguments& segments,
  const std::function<void(const std::string& flag, const std::string& text)>& given);

struct Arguments;

/// What contradicts --segments, and --label-names without it. @throws Failure(ExitCode::Usage)
void CheckSegments(const Arguments& arguments);
}

#endif
