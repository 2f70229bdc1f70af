// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "XmlNesting.h"

#include "FileChecks.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr std::int64_t MostLevels = 64;
constexpr std::int64_t MostArrays = 10000;

/// Visits the tags of a file from its beginning to its appended data, which need not be text.
class TagWalk
{
public:
  explicit TagWalk(const std::string& path)
    : Path(path)
    , Stream(path, std::ios::binary)
  {
  }

  void Run()
  {
    while (!this->IsAtAppendedData && this->SkipTo('<'))
    {
      this->ReadTag();
    }
  }

private:
  bool SkipTo(char end)
  {
    this->Stream.ignore(std::numeric_limits<std::streamsize>::max(), end);
    return bool(this->Stream);
  }

  /// Text that ends a comment or the like.
  void SkipBehind(const std::string& end)
  {
    std::string last;
    char c = 0;
    while (this->Stream.get(c) && last != end)
    {
      last += c;
      last.erase(0, last.size() - std::min(last.size(), end.size()));
    }
    this->Stream.unget();
  }

  void ReadTag()
  {
    char c = 0;
    std::string name;
    while (name.size() < 16 && this->Stream.get(c) && c != '>' && c != ' ' && c != '/' && c != '\n')
    {
      name += c;
      if (name == "!--" || name == "![CDATA[")
      {
        return this->SkipBehind(name == "!--" ? "-->" : "]]>");
      }
    }
    const bool isEnd = name.empty() && c == '/';
    const bool isEmpty = this->SkipRestOfTag(c) && !isEnd;
    if (!name.empty() && (name[0] == '?' || name[0] == '!'))
    {
      return;
    }
    this->IsAtAppendedData = name == "AppendedData";
    this->Arrays += name == "DataArray" || name == "Array" ? 1 : 0;
    this->Depth += isEnd ? -1 : isEmpty ? 0 : 1;
    this->RejectIfTooMany();
  }

  /// Whether the tag ends with a slash. A bracket between quotes is text.
  bool SkipRestOfTag(char c)
  {
    char before = 0;
    char quote = 0;
    for (bool hasMore = true; hasMore && (quote != 0 || c != '>');
         hasMore = bool(this->Stream.get(c)))
    {
      const bool isQuote = c == '"' || c == '\'';
      quote = quote == 0 && isQuote ? c : quote == c ? char(0) : quote;
      before = c;
    }
    return before == '/';
  }

  void RejectIfTooMany() const
  {
    if (this->Depth > MostLevels)
    {
      Reject(this->Path,
        "its XML elements are nested more than " + std::to_string(MostLevels) + " levels deep");
    }
    if (this->Arrays > MostArrays)
    {
      Reject(this->Path, "it has more than " + std::to_string(MostArrays) + " arrays");
    }
  }

  const std::string& Path;
  std::ifstream Stream;
  std::int64_t Depth = 0;
  std::int64_t Arrays = 0;
  bool IsAtAppendedData = false;
};
}

void CheckNesting(const std::string& path)
{
  TagWalk(path).Run();
}
}
