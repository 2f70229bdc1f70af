// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineReader.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

/// But for blanks behind it.
bool EndsWithBackslash(const std::string& line)
{
  const auto last = std::find_if_not(line.rbegin(), line.rend(), IsBlank);
  return last != line.rend() && *last == '\\';
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

/// All lines that follow each other, in a time that grows with their length.
bool LineReader::Continue()
{
  std::string whole = std::move(this->Line);
  bool hasNext = true;
  while (hasNext && EndsWithBackslash(whole))
  {
    whole.erase(whole.rfind('\\'));
    whole += ' ';
    hasNext = this->Next();
    whole += this->Line;
  }
  this->Line = std::move(whole);
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
  SplitWords(this->Line, this->Words);
  return this->Words;
}

void SplitWords(std::string_view text, std::vector<std::string_view>& words)
{
  for (std::size_t i = 0; i < text.size();)
  {
    std::size_t end = i;
    while (end < text.size() && !IsBlank(text[end]))
    {
      ++end;
    }
    if (end > i)
    {
      words.push_back(text.substr(i, end - i));
    }
    i = end + 1;
  }
}
}
