// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExitCode.h"

namespace bonedecimate
{
const std::vector<std::pair<ExitCode, std::string>>& ExitCodeMeanings()
{
  static const std::vector<std::pair<ExitCode, std::string>> codes = {
    { ExitCode::Done, "done" },
    { ExitCode::Usage, "usage: an option or a name is wrong, nothing was read" },
    { ExitCode::InputRejected, "the input was rejected, nothing was written" },
    { ExitCode::CouldNotWrite,
      "a file could not be written, or the picture of --picture could not be drawn" },
    { ExitCode::Interrupted,
      "interrupted, or beyond --time-limit; nothing of that input was written. certify: the bounds "
      "proved until then were written" },
    { ExitCode::OutOfMemory,
      "out of memory, or beyond --memory-limit; nothing of that input was written" },
    { ExitCode::Violated,
      "certify: the tolerance is not kept, or a voxel has another label; 0 means that it is proved "
      "to be kept and that no voxel changed. tolerance: no surface "
      "has so few triangles. Otherwise: the certificate contradicts the requested largest error, a "
      "defect" },
    { ExitCode::Undecided,
      "the certificate could prove neither that the tolerance is kept nor that it is violated" },
    { ExitCode::LeftOut,
      "of a batch: volumes were left out, because neither --iso nor --segments says what to take "
      "from them; all else is done" },
  };
  return codes;
}

std::string ExitCodesText()
{
  std::string text = "Exit codes:\n";
  for (const auto& [code, meaning] : ExitCodeMeanings())
  {
    text += "  " + std::to_string(static_cast<int>(code)) + "  " + meaning + "\n";
  }
  return text;
}

void RequireUsage(bool isRight, const std::string& problem)
{
  if (!isRight)
  {
    throw Failure(ExitCode::Usage, problem);
  }
}
}
