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
