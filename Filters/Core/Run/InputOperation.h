// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputOperation.h
 * @brief Changes the input before a run, and afterwards makes the result refer to the input as it
 * was read.
 *
 *     for each operation that the options request, in order:   Apply(request)
 *     result = run of the request
 *     for each of them, the last first:                        Restore(result)
 */
#ifndef BoneDecimate_Core_Run_InputOperation_h
#define BoneDecimate_Core_Run_InputOperation_h

#include "Base/Monitor.h"
#include "Options/Options.h"
#include "Run/Input/RunInputs.h"
#include "Run/Output/Result.h"

#include <memory>
#include <string>
#include <vector>

namespace bonedecimate
{
/// What a run reads.
struct RunRequest
{
  const Surface* Input;
  bonedecimate::Options Options;
  RunInputs Inputs;
};

class InputOperation
{
public:
  virtual ~InputOperation() = default;

  /// Changes the request, which may then refer to members of this object.
  /// @return Why the request cannot be fulfilled, a sentence without a period; empty: it can.
  virtual std::string Apply(RunRequest& request, const Monitor& monitor) = 0;

  /// @param result That of the request as Apply() changed it.
  virtual void Restore(Result& result) = 0;
};

/// Those that the options request, in the order in which they are applied.
std::vector<std::unique_ptr<InputOperation>> InputOperations(const Options& options);
}

#endif
