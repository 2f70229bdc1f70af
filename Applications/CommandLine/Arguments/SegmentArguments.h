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
/// The table of labels that the program knows.
inline constexpr const char* TotalSegmentatorWord = "totalsegmentator";

struct SegmentArguments
{
  std::string Choice;     ///< See ChooseSegments(); empty: the input is no label map.
  std::string LabelNames; ///< TotalSegmentatorWord or the path of a table; empty: not given.

  bool IsRequested() const { return !this->Choice.empty(); }
  bool HasTotalSegmentatorNames() const { return this->LabelNames == TotalSegmentatorWord; }
};

/// Adds --segments and --label-names. @param given Receives flag without dashes and text.
void AddSegments(CLI::App& app, SegmentArguments& segments,
  const std::function<void(const std::string& flag, const std::string& text)>& given);

/// Adds --model-grid.
void AddModelGrid(CLI::App& app, std::string& choice,
  const std::function<void(const std::string& flag, const std::string& text)>& given);

struct Arguments;

/// What contradicts --segments, and --label-names without it. @throws Failure(ExitCode::Usage)
void CheckSegments(const Arguments& arguments);
}

#endif
