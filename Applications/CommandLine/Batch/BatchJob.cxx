// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchJob.h"

#include "Arguments/MemoryArguments.h"
#include "BatchOptions.h"
#include "NumberText.h"

namespace bonedecimate
{
BatchJob::BatchJob(
  std::size_t index, const std::string& self, const BatchBone& bone, const Arguments& arguments)
  : Bone(index)
  , Child(self, WordsFor(bone, arguments))
  , TimeLimit(arguments.TimeLimit)
  , MemoryLimit(arguments.MemoryLimit)
{
}

void BatchJob::InterruptBeyondLimits()
{
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - this->Begin;
  if (!this->Excess.empty())
  {
    return;
  }
  if (this->TimeLimit > 0.0 && seconds.count() > this->TimeLimit)
  {
    this->Excess = "took longer than the " + GroupedText(this->TimeLimit) + " s of --time-limit";
    this->Child.Interrupt();
  }
  else if (this->MemoryLimit > 0 && this->Child.GetMemory() > this->MemoryLimit)
  {
    this->Excess = "needed more than the " + MiBText(this->MemoryLimit) + " of --memory-limit";
    this->CodeOfExcess = ExitCode::OutOfMemory;
    this->Child.Interrupt();
  }
}
}
