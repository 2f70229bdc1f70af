// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FailureLog.h"

#include "ChildProcess.h"
#include "FilePath.h"
#include "Files/StagedFile.h"

#include <fstream>
#include <iterator>
#include <regex>

namespace bonedecimate
{
void WriteFailureLog(
  const std::string& path, const std::string& printed, const std::string& input, ExitCode code)
{
  const bool isLine = printed.empty() || printed.back() == '\n';
  WriteTextFile(path,
    printed + (isLine ? "" : "\n") + input + ": exit code " +
      std::to_string(static_cast<int>(code)) + "\n");
}

//------------------------------------------------------------------------------
std::optional<BatchRow> ReadFailureLog(const std::string& path)
{
  std::ifstream stream(FilePath(path), std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  static const std::regex ending("(?:^|\n)([^\n]+): exit code ([1-8])\n$");
  std::smatch found;
  if (!std::regex_search(text, found, ending))
  {
    return std::nullopt;
  }
  BatchRow row;
  row.Input = found[1];
  row.Status = "failed";
  row.Code = static_cast<ExitCode>(std::stoi(found[2]));
  row.Message = MessageIn(text.substr(0, static_cast<std::size_t>(found.position(1))));
  return row;
}
}
