// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchJob.h
 * @brief An input of a batch at work, in a process of its own.
 */
#ifndef BoneDecimate_Applications_BatchJob_h
#define BoneDecimate_Applications_BatchJob_h

#include "Arguments/Arguments.h"
#include "BatchPlan.h"
#include "ChildProcess.h"

#include <chrono>
#include <cstdint>
#include <string>

namespace bonedecimate
{
class BatchJob
{
public:
  /// Starts the process.  @param index Index of the bone in the batch.
  BatchJob(
    std::size_t index, const std::string& self, const BatchBone& bone, const Arguments& arguments);

  /// Interrupts the process if it exceeds --time-limit or --memory-limit.
  void InterruptBeyondLimits();

  std::size_t Bone;
  ChildProcess Child;
  std::string Excess; ///< Which limit it exceeded; empty: none.
  ExitCode CodeOfExcess = ExitCode::Interrupted;

private:
  double TimeLimit;
  std::int64_t MemoryLimit;
  std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now();
};
}

#endif
