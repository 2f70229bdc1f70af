// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineReader.h"

#include "FileChecks.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr std::size_t Npos = std::string::npos;

bool IsAsciiBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

/// Bytes of the blank that begins at a position; 0: there is none.
std::size_t BlankAt(std::string_view text, std::size_t position)
{
  const char c = text[position];
  if (static_cast<unsigned char>(c) < 0x80)
  {
    return IsAsciiBlank(c) ? 1 : 0;
  }
  const std::string_view rest = text.substr(position);
  const auto begins = [&rest](const char* bytes) { return rest.rfind(bytes, 0) == 0; };
  if (begins("\xC2\xA0"))
  {
    return 2;
  }
  const bool isSpace = begins("\xEF\xBB\xBF") || begins("\xE2\x80\xAF") || begins("\xE3\x80\x80") ||
    (begins("\xE2\x80") && rest.size() > 2 && static_cast<unsigned char>(rest[2]) <= 0x8B);
  return isSpace ? 3 : 0;
}

/// Bytes of the blank that ends before a position; 0: there is none.
std::size_t BlankBefore(std::string_view text, std::size_t end)
{
  for (std::size_t bytes = 1; bytes <= std::min<std::size_t>(3, end); ++bytes)
  {
    if (BlankAt(text.substr(0, end), end - bytes) == bytes)
    {
      return bytes;
    }
  }
  return 0;
}
}

LineReader::LineReader(const std::string& path)
  : Path(path)
  , Stream(path, std::ios::binary)
{
}

bool LineReader::Next()
{
  if (!this->ReadLine())
  {
    return false;
  }
  ++this->Number;
  this->IsSplit = false;
  if (this->Number == 1)
  {
    this->RejectWideText();
    this->EndsWithCarriageReturn = this->HasBlock;
  }
  return true;
}

void LineReader::RejectWideText() const
{
  if (this->Line.rfind("\xFF\xFE", 0) == 0 || this->Line.rfind("\xFE\xFF", 0) == 0)
  {
    Reject(this->Path, "it is UTF-16 text; save it as UTF-8");
  }
}

/// A block of text has several lines if there are carriage returns in it.
bool LineReader::ReadLine()
{
  if (!this->HasBlock)
  {
    if (!std::getline(this->Stream, this->Block))
    {
      return false;
    }
    this->BlockEnded = !this->Stream.eof();
    this->Begin = 0;
    if (this->Block.find('\r') == Npos)
    {
      this->Line.swap(this->Block);
      this->Ended = this->BlockEnded;
      return true;
    }
  }
  const std::size_t end = this->Block.find('\r', this->Begin);
  this->Line.assign(this->Block, this->Begin, end == Npos ? Npos : end - this->Begin);
  const bool isLast = end == Npos ||
    (end + 1 == this->Block.size() && !(this->BlockEnded && this->EndsWithCarriageReturn));
  this->Begin = isLast ? this->Block.size() : end + 1;
  this->HasBlock = !isLast;
  this->Ended = end != Npos || this->BlockEnded;
  return true;
}

std::ifstream& LineReader::GetStream()
{
  if (this->HasBlock)
  {
    const auto left =
      static_cast<std::streamoff>(this->Block.size() - this->Begin) + (this->BlockEnded ? 1 : 0);
    this->Stream.clear();
    this->Stream.seekg(-left, std::ios::cur);
    this->HasBlock = false;
  }
  return this->Stream;
}

bool LineReader::Continue()
{
  std::string whole = std::move(this->Line);
  whole.erase(std::min(whole.rfind('\\'), whole.size()));
  whole += ' ';
  const bool hasNext = this->Next();
  whole += hasNext ? this->Line : std::string();
  this->Line = std::move(whole);
  return hasNext;
}

bool LineReader::IsContinued() const
{
  const std::string_view line = Trimmed(this->Line);
  return !line.empty() && line.back() == '\\';
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

//------------------------------------------------------------------------------
void SplitWords(std::string_view text, std::vector<std::string_view>& words)
{
  for (std::size_t i = 0; i < text.size();)
  {
    std::size_t end = i;
    std::size_t blank = 0;
    while (end < text.size() && (blank = BlankAt(text, end)) == 0)
    {
      ++end;
    }
    if (end > i)
    {
      words.push_back(text.substr(i, end - i));
    }
    i = end + std::max<std::size_t>(1, blank);
  }
}

//------------------------------------------------------------------------------
std::string_view Trimmed(std::string_view text)
{
  while (!text.empty())
  {
    const std::size_t front = BlankAt(text, 0);
    const std::size_t back = front == 0 ? BlankBefore(text, text.size()) : 0;
    if (front == 0 && back == 0)
    {
      break;
    }
    text.remove_prefix(front);
    text.remove_suffix(back);
  }
  return text;
}
}
