// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchOutput.h
 * @brief What a batch prints: a line for each input, and how many have ended.
 */
#ifndef BoneDecimate_Applications_BatchOutput_h
#define BoneDecimate_Applications_BatchOutput_h

#include "Arguments/Arguments.h"

#include <chrono>
#include <cstddef>
#include <string>

namespace bonedecimate
{
class BatchOutput
{
public:
  explicit BatchOutput(const Arguments& arguments);

  void Tell(const std::string& line) const;

  /// Even if the batch is quiet: then on the standard error.
  void TellFailure(const std::string& line) const;

  /// Inputs that have ended: on a terminal always, in a file every ten minutes; with --progress on
  /// the standard error whenever there are more.
  void Show(std::size_t ended, std::size_t all);

private:
  bool Quiet;
  bool Terminal;
  bool Lines; ///< By --progress.
  std::size_t Shown = 0;
  std::chrono::steady_clock::time_point Told = std::chrono::steady_clock::now();
};
}

#endif
