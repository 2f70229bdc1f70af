// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextOutput.h"

#include "ExitCode.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>

namespace bonedecimate
{
std::string WriteProblem()
{
  return errno != 0 ? std::strerror(errno) : "the file could not be written";
}

TextOutput::TextOutput(const std::string& path)
{
  errno = 0;
  this->Stream.open(path, std::ios::binary | std::ios::trunc);
}

void TextOutput::Add(std::string_view text)
{
  this->Stream.write(text.data(), static_cast<std::streamsize>(text.size()));
}

void TextOutput::AddNumber(double number, bool isSingle)
{
  std::array<char, 32> digits = {};
  digits[0] = ' ';
  char* const first = digits.data() + 1;
  char* const last = digits.data() + digits.size();
  const std::to_chars_result result = isSingle
    ? std::to_chars(first, last, static_cast<float>(number))
    : std::to_chars(first, last, number);
  this->Add({ digits.data(), static_cast<std::size_t>(result.ptr - digits.data()) });
}

void TextOutput::Close()
{
  this->Stream.close();
  if (!this->Stream)
  {
    throw Failure(ExitCode::CouldNotWrite, WriteProblem());
  }
}
}
