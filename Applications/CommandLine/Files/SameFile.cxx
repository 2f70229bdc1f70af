// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SameFile.h"

#include "ExitCode.h"
#include "FilePath.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace fs = std::filesystem;

namespace bonedecimate
{
bool IsSameFile(const std::string& a, const std::string& b)
{
  std::error_code error;
  return fs::equivalent(FilePath(a), FilePath(b), error) ||
    fs::absolute(FilePath(a), error).lexically_normal() ==
    fs::absolute(FilePath(b), error).lexically_normal();
}

void RequireDistinct(
  const std::vector<std::string>& outputs, const std::vector<std::string>& inputs)
{
  for (auto output = outputs.begin(); output != outputs.end(); ++output)
  {
    const auto isIt = [output](const std::string& other)
    { return !output->empty() && !other.empty() && IsSameFile(*output, other); };
    if (std::any_of(inputs.begin(), inputs.end(), isIt))
    {
      throw Failure(ExitCode::Usage, "'" + *output + "' is an input; it is not overwritten");
    }
    if (std::any_of(output + 1, outputs.end(), isIt))
    {
      throw Failure(ExitCode::Usage, "'" + *output + "' would be written twice");
    }
  }
}
}
