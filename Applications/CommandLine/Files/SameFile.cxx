// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SameFile.h"

#include "Base/Text.h"
#include "ExitCode.h"
#include "FilePath.h"
#include "Formats/SurfaceFormat.h"

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

namespace
{
/// Whether a file lies below one of these folders, and is none of the kinds that reports have: it
/// may be a slice.
bool IsPartOfInput(const std::string& file, const std::vector<std::string>& inputs)
{
  std::error_code error;
  const fs::path path = fs::weakly_canonical(FilePath(file), error);
  const std::string extension = LowerCase(path.extension().string());
  const bool isReport = extension == ".json" || extension == ".html" || extension == ".htm" ||
    extension == ".png" || extension == ".csv";
  const auto isAbove = [&](const std::string& folder)
  {
    const fs::path below = path.lexically_relative(fs::weakly_canonical(FilePath(folder), error));
    return fs::is_directory(FilePath(folder), error) && !below.empty() && *below.begin() != "..";
  };
  return !isReport && FindFormat(file) == nullptr && fs::is_regular_file(path, error) &&
    std::any_of(inputs.begin(), inputs.end(), isAbove);
}
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
    if (!output->empty() && IsPartOfInput(*output, inputs))
    {
      throw Failure(ExitCode::Usage,
        "'" + *output + "' lies in a folder that is an input; it is not overwritten");
    }
    if (std::any_of(output + 1, outputs.end(), isIt))
    {
      throw Failure(ExitCode::Usage, "'" + *output + "' would be written twice");
    }
  }
}
}
