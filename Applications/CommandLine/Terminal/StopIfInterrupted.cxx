// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExitCode.h"
#include "Interruption.h"

namespace bonedecimate
{
void StopIfInterrupted()
{
  if (IsInterrupted())
  {
    throw Failure(ExitCode::Interrupted, "interrupted");
  }
}
}
