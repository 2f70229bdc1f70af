// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StandardOutput.h"

#include "ExitCode.h"
#include "Terminal/ClosedPipe.h"

#include <algorithm>
#include <cerrno>
#include <iostream>

namespace bonedecimate
{
namespace
{
std::streambuf* OutputOfFile = nullptr;

/// The value behind "--report=", or the word.
std::string ValueIn(const std::string& word)
{
  const bool isOption = word.rfind("--", 0) == 0;
  return isOption && word.find('=') != std::string::npos ? word.substr(word.find('=') + 1) : word;
}
}

bool IsStandardOutput(const std::string& name)
{
  return name == "-" || name == "/dev/stdout";
}

StandardOutputForFile::StandardOutputForFile(const std::vector<std::string>& words)
{
  if (std::any_of(words.begin(), words.end(),
        [](const std::string& word) { return IsStandardOutput(ValueIn(word)); }))
  {
    this->Output = std::cout.rdbuf(std::cerr.rdbuf());
    OutputOfFile = this->Output;
  }
}

StandardOutputForFile::~StandardOutputForFile()
{
  if (this->Output != nullptr)
  {
    OutputOfFile = nullptr;
    std::cout.rdbuf(this->Output);
  }
}

void WriteToStandardOutput(const std::string& text)
{
  std::ostream output(OutputOfFile != nullptr ? OutputOfFile : std::cout.rdbuf());
  errno = 0;
  if (!output.write(text.data(), static_cast<std::streamsize>(text.size())).flush() &&
    !IsClosedPipe(errno))
  {
    throw Failure(ExitCode::CouldNotWrite, "could not write to the standard output");
  }
}
}
