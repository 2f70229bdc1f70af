// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// VTK's legacy format: its reader allocates by what is announced, and follows a file that it has
/// closed.
#include "Base/Text.h"
#include "CoordinateCollector.h"
#include "FileChecks.h"
#include "FilePath.h"
#include "LineReader.h"

#include <filesystem>
#include <map>

namespace bonedecimate
{
namespace
{
constexpr std::int64_t NumberLength = 2; // of the shortest number in text, with the blank after it

std::size_t BytesOf(std::string_view type)
{
  static const std::map<std::string, std::size_t> bytes = { { "char", 1 }, { "unsigned_char", 1 },
    { "short", 2 }, { "unsigned_short", 2 }, { "int", 4 }, { "unsigned_int", 4 }, { "float", 4 },
    { "long", 8 }, { "unsigned_long", 8 }, { "double", 8 }, { "vtktypeint32", 4 },
    { "vtktypeint64", 8 }, { "vtkidtype", 4 } };
  const auto found = bytes.find(LowerCase(std::string(type)));
  return found == bytes.end() ? 0 : found->second;
}

bool IsCells(const std::string& word)
{
  return word == "vertices" || word == "lines" || word == "polygons" || word == "triangle_strips";
}

class VtkCheck
{
public:
  VtkCheck(const std::string& path, CoordinateCollector& textPoints)
    : Path(path)
    , TextPoints(textPoints)
    , Lines(path)
    , Size(static_cast<std::int64_t>(std::filesystem::file_size(FilePath(path))))
  {
  }

  void Run()
  {
    this->ReadHeader();
    while (this->Lines.Next())
    {
      this->CheckLine(this->Lines.GetWords());
    }
  }

private:
  [[noreturn]] void RejectLine(const std::string& reason)
  {
    Reject(this->Path, this->Lines.Prefix() + reason);
  }

  void ReadHeader()
  {
    const std::string begin = "# vtk datafile version ";
    const bool hasLine = this->Lines.Next();
    const std::string first =
      hasLine ? LowerCase(std::string(Trimmed(this->Lines.GetLine()))) : std::string();
    if (first.compare(0, begin.size(), begin) != 0)
    {
      Reject(this->Path, "it does not begin with '# vtk DataFile Version'");
    }
    const std::string version = first.substr(begin.size());
    this->HasOffsets = !version.empty() && version[0] >= '5';
    this->Lines.Next(); // a title
    this->Lines.Next();
    const std::vector<std::string_view>& words = this->Lines.GetWords();
    const std::string form = words.size() == 1 ? LowerCase(std::string(words[0])) : std::string();
    this->Binary = form == "binary";
    if (!this->Binary && form != "ascii")
    {
      this->RejectLine("neither ASCII nor BINARY");
    }
  }

  void CheckLine(const std::vector<std::string_view>& words)
  {
    const std::string word = words.empty() ? std::string() : LowerCase(std::string(words[0]));
    if (words.size() == 2 && word == "dataset" && LowerCase(std::string(words[1])) != "polydata")
    {
      this->RejectLine("it holds '" + std::string(words[1]) + "', not POLYDATA");
    }
    if (words.size() == 3 && word == "points")
    {
      const std::int64_t points = this->ReadCount(words[1]);
      this->SkipNumbers(3 * points, words[2], &this->TextPoints);
    }
    else if (words.size() == 3 && IsCells(word))
    {
      this->Cells = this->ReadCount(words[1]);
      this->Corners = this->ReadCount(words[2]);
      if (!this->HasOffsets)
      {
        this->WalkCells();
      }
    }
    else if (words.size() == 2 && (word == "offsets" || word == "connectivity"))
    {
      this->SkipNumbers(word == "offsets" ? this->Cells : this->Corners, words[1]);
    }
    else if (words.size() == 2 && (word == "point_data" || word == "cell_data"))
    {
      this->ReadCount(words[1]);
    }
  }

  std::int64_t ReadCount(std::string_view word)
  {
    const std::int64_t count = ParseNumber<std::int64_t>(word).value_or(-1);
    if (count < 0 || count > this->Size)
    {
      this->RejectLine("more is announced than a file of this size can hold");
    }
    return count;
  }

  void SkipNumbers(std::int64_t count, std::string_view type, CoordinateCollector* texts = nullptr)
  {
    const std::int64_t bytes = static_cast<std::int64_t>(BytesOf(type));
    if (bytes == 0 || count * (this->Binary ? bytes : NumberLength) > this->Size)
    {
      this->RejectLine("an unknown type, or more than a file of this size can hold");
    }
    if (this->Binary)
    {
      this->Lines.GetStream().ignore(count * bytes);
      this->RequireWhole(this->Lines.GetStream().gcount() == count * bytes);
      return;
    }
    for (std::int64_t i = 0; i < count; ++i)
    {
      const std::optional<double> number = ParseNumber<double>(this->NextWord());
      this->RequireWhole(number.has_value());
      if (texts)
      {
        texts->Add(*number);
      }
    }
  }

  /// Before version 5: every cell is its number of corners and then they.
  void WalkCells()
  {
    std::int64_t left = this->Corners;
    for (std::int64_t i = 0; i < this->Cells; ++i)
    {
      const std::int64_t corners = this->NextInteger();
      this->RequireWhole(corners >= 0 && corners < left);
      left -= corners + 1;
      for (std::int64_t j = 0; j < corners; ++j)
      {
        this->NextInteger();
      }
    }
    this->RequireWhole(left == 0);
  }

  std::int64_t NextInteger()
  {
    if (!this->Binary)
    {
      const auto value = ParseNumber<std::int64_t>(this->NextWord());
      this->RequireWhole(value.has_value());
      return *value;
    }
    std::int64_t value = 0;
    unsigned char raw[4] = {};
    this->Lines.GetStream().read(reinterpret_cast<char*>(raw), sizeof(raw));
    this->RequireWhole(static_cast<bool>(this->Lines.GetStream()));
    for (const unsigned char byte : raw)
    {
      value = value * 256 + byte;
    }
    return value;
  }

  /// The next word of the data that follow a line of text, whatever their lines.
  std::string_view NextWord()
  {
    if (this->LineOfWord != this->Lines.GetNumber())
    {
      this->Word = this->Lines.GetWords().size(); // the line that announced the data
    }
    while (this->Word >= this->Lines.GetWords().size() && this->Lines.Next())
    {
      this->Word = 0;
    }
    this->LineOfWord = this->Lines.GetNumber();
    return this->Word < this->Lines.GetWords().size() ? this->Lines.GetWords()[this->Word++]
                                                      : std::string_view();
  }

  void RequireWhole(bool whole)
  {
    if (!whole)
    {
      this->RejectLine("the points or cells end or break here");
    }
  }

  const std::string& Path;
  CoordinateCollector& TextPoints;
  LineReader Lines;
  std::int64_t Size;
  bool Binary = false;
  bool HasOffsets = false; // version 5: offsets and corners lie in arrays of their own
  std::int64_t Cells = 0;
  std::int64_t Corners = 0;
  std::size_t Word = 0; // the next one of the line
  std::int64_t LineOfWord = 0;
};
}

void CheckVtkFile(const std::string& path, CoordinateCollector& textPoints)
{
  VtkCheck(path, textPoints).Run();
}
}
