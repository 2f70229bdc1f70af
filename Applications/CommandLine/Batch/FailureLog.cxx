// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FailureLog.h"

#include "ChildProcess.h"
#include "FilePath.h"
#include "Files/StagedFile.h"

#include <fstream>
#include <utility>

namespace bonedecimate
{
namespace
{
const std::string BeforeCode = ": exit code ";
}

//------------------------------------------------------------------------------
void WriteFailureLog(
  const std::string& path, const std::string& printed, const std::string& input, ExitCode code)
{
  const bool isLine = printed.empty() || printed.back() == '\n';
  WriteTextFile(path,
    printed + (isLine ? "" : "\n") + input + BeforeCode + std::to_string(static_cast<int>(code)) +
      "\n");
}

//------------------------------------------------------------------------------
std::optional<BatchRow> ReadFailureLog(const std::string& path)
{
  std::ifstream stream(FilePath(path), std::ios::binary);
  std::string first, last;
  for (std::string line; std::getline(stream, line); last = std::move(line))
  {
    first = first.empty() ? line : first;
  }
  const std::size_t ending = last.rfind(BeforeCode);
  if (ending == std::string::npos || ending == 0 || ending + BeforeCode.size() + 1 != last.size() ||
    last.back() < '1' || last.back() > '8')
  {
    return std::nullopt;
  }
  BatchRow row;
  row.Input = last.substr(0, ending);
  row.Status = "failed";
  row.Code = static_cast<ExitCode>(last.back() - '0');
  row.Message = MessageIn(first);
  return row;
}
}
