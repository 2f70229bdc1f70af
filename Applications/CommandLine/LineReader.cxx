// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineReader.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <utility>

namespace bonedecimate
{
namespace
{
bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// A number may begin with a plus sign, which from_chars does not know.
std::string_view WithoutPlus(std::string_view word)
{
  const bool signedTwice = word.size() > 1 && (word[1] == '-' || word[1] == '+');
  return !word.empty() && word[0] == '+' && !signedTwice ? word.substr(1) : word;
}
}

LineReader::LineReader(const std::string& path)
  : Stream(path, std::ios::binary)
{
}

bool LineReader::Next()
{
  if (!std::getline(this->Stream, this->Line))
  {
    return false;
  }
  ++this->Number;
  this->IsSplit = false;
  this->Ended = !this->Stream.eof();
  return true;
}

bool LineReader::Continue()
{
  std::string begin = std::move(this->Line);
  begin.erase(std::min(begin.rfind('\\'), begin.size()));
  const bool hasNext = this->Next();
  this->Line.insert(0, begin + ' ');
  return hasNext;
}

const std::vector<std::string_view>& LineReader::GetWords()
{
  if (this->IsSplit)
  {
    return this->Words;
  }
  this->IsSplit = true;
  this->Words.clear();
  const std::string_view line = this->Line;
  for (std::size_t i = 0; i < line.size();)
  {
    std::size_t end = i;
    while (end < line.size() && !IsBlank(line[end]))
    {
      ++end;
    }
    if (end > i)
    {
      this->Words.push_back(line.substr(i, end - i));
    }
    i = end + 1;
  }
  return this->Words;
}

bool ReadNumber(std::string_view word, double& value)
{
  const std::string_view digits = WithoutPlus(word);
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (read.ec == std::errc::result_out_of_range)
  {
    value = std::strtod(std::string(digits).c_str(), nullptr);
  }
  return read.ec != std::errc::invalid_argument && read.ptr == digits.data() + digits.size();
}

bool ReadFiniteNumber(std::string_view word, double& value)
{
  // The words nan, inf and infinity have an n, no number has.
  return ReadNumber(word, value) && word.find_first_of("nN") == std::string_view::npos;
}

bool IsNumber(std::string_view word)
{
  double value = 0.0;
  return ReadNumber(word, value);
}

bool ReadInteger(std::string_view word, std::int64_t& value)
{
  const std::string_view digits = WithoutPlus(word);
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return read.ec == std::errc() && read.ptr == digits.data() + digits.size();
}
}
