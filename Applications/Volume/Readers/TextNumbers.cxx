// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextNumbers.h"

#include "Base/Text.h"

namespace bonedecimate::volume
{
std::string Trimmed(const std::string& text)
{
  const std::string blanks(" \t\r\n\0", 5);
  const std::size_t first = text.find_first_not_of(blanks);
  const std::size_t last = text.find_last_not_of(blanks);
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

std::optional<std::vector<double>> ParseNumbers(const std::string& text)
{
  const std::string between = " \t\r\n,\\";
  std::vector<double> numbers;
  std::size_t first = text.find_first_not_of(between);
  while (first != std::string::npos)
  {
    const std::size_t end = std::min(text.find_first_of(between, first), text.size());
    const auto number = ParseNumber<double>(std::string_view(text).substr(first, end - first));
    if (!number)
    {
      return std::nullopt;
    }
    numbers.push_back(*number);
    first = text.find_first_not_of(between, end);
  }
  return numbers;
}

std::optional<std::int64_t> ParseWholeNumber(const std::string& text)
{
  return ParseNumber<std::int64_t>(Trimmed(text));
}
}
