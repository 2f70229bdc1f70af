// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels/LabelTable.h"

#include "Base/Text.h"
#include "PlainText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr const char* Blanks = " \t";
constexpr const char* NotThere = "n/a"; // of BIDS
constexpr std::size_t Missing = std::string::npos;

std::string Trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(Blanks) - first + 1);
}

std::string Quoted(const std::string& text)
{
  return "'" + PlainText(text.substr(0, LongestQuote)) + "'";
}

/// A whole number, also one that is written as 1.0.
std::optional<std::int64_t> LabelOf(const std::string& text)
{
  constexpr double most = 9007199254740992.0;
  const auto label = ParseNumber<std::int64_t>(text);
  const double number = label ? most : ParseFinite(text).value_or(most);
  const bool isWhole = std::abs(number) < most && !(std::floor(number) < number);
  return isWhole ? static_cast<std::int64_t>(number) : label;
}

/// Red, green and blue as the file has them, which end at 1 or at 255.
using FileColor = std::array<double, 3>;

/// What lines of all formats have in common.
class LineReader
{
public:
  virtual ~LineReader() = default;

  /// Reads a line that is not empty. @return What is wrong with it, or an empty text.
  virtual std::string Read(const std::string& line) = 0;

  bool HasLabels() const { return !this->Table.Labels.empty(); }

  LabelTable TakeTable()
  {
    const double scale = this->HasBytes ? 1.0 : 255.0;
    for (std::size_t i = 0; i < this->Table.Labels.size(); ++i)
    {
      if (this->Colors[i])
      {
        LabelColor color = {};
        std::transform(this->Colors[i]->begin(), this->Colors[i]->end(), color.begin(),
          [scale](double value) { return static_cast<unsigned char>(std::lround(scale * value)); });
        this->Table.Labels[i].Color = color;
      }
    }
    return std::move(this->Table);
  }

protected:
  std::string Add(
    const std::string& number, const std::string& name, const std::optional<FileColor>& color)
  {
    const std::optional<std::int64_t> label = LabelOf(number);
    if (!label)
    {
      return Quoted(number) + " is no label, which is a whole number";
    }
    for (const double value : color.value_or(FileColor{}))
    {
      if (!(value >= 0.0 && value <= 255.0))
      {
        return "its color is not within 0 to 255";
      }
      this->HasBytes = this->HasBytes || value > 1.0;
    }
    this->Table.Labels.push_back({ *label, name, {} });
    this->Colors.push_back(color);
    return std::string();
  }

  /// Color of the three texts in these columns; nothing if one is no number.
  static std::optional<FileColor> ColorAt(
    const std::vector<std::string>& texts, const std::array<std::size_t, 3>& columns)
  {
    FileColor color = {};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::string text =
        columns[axis] < texts.size() ? Trimmed(texts[columns[axis]]) : std::string();
      const std::optional<double> number = ParseFinite(text);
      if (!number)
      {
        return std::nullopt;
      }
      color[axis] = *number;
    }
    return color;
  }

  LabelTable Table;
  bool HasBytes = false; ///< Colors end at 255.

private:
  std::vector<std::optional<FileColor>> Colors;
};

/// Lines of ITK-SNAP, 3D Slicer and FreeSurfer.
class ColorLines : public LineReader
{
public:
  std::string Read(const std::string& whole) override
  {
    const std::string line = Trimmed(whole);
    return line.back() == '"' ? this->ReadDescription(line) : this->ReadColor(line);
  }

private:
  static std::vector<std::string> WordsOf(const std::string& line)
  {
    std::vector<std::string> words;
    for (std::size_t begin = line.find_first_not_of(Blanks); begin != std::string::npos;)
    {
      const std::size_t end = std::min(line.find_first_of(Blanks, begin), line.size());
      words.push_back(line.substr(begin, end - begin));
      begin = line.find_first_not_of(Blanks, end);
    }
    return words;
  }

  std::string ReadDescription(const std::string& line)
  {
    const std::size_t quote = line.find('"');
    const std::vector<std::string> words = WordsOf(line.substr(0, quote));
    const auto color = ColorAt(words, { { 1, 2, 3 } });
    if (words.size() != 7 || !color || quote + 1 == line.size())
    {
      return "it is no label description, which is a label, six numbers and a name in quotation "
             "marks";
    }
    return this->Add(words[0], line.substr(quote + 1, line.size() - quote - 2), color);
  }

  /// A name may have blanks.
  std::string ReadColor(const std::string& line)
  {
    const std::vector<std::string> words = WordsOf(line);
    const std::size_t count = words.size();
    const auto color = count < 6 ? std::optional<FileColor>()
                                 : ColorAt(words, { { count - 4, count - 3, count - 2 } });
    if (!color)
    {
      return std::string("it is no row of a color table, which is a label, a name and four "
                         "numbers") +
        (this->HasLabels() ? "" : ", and no heading with the columns index and name");
    }
    std::string name = words[1];
    for (std::size_t i = 2; i + 4 < count; ++i)
    {
      name += " " + words[i];
    }
    const bool isQuoted = name.size() > 1 && name.front() == '"' && name.back() == '"';
    name = isQuoted ? name.substr(1, name.size() - 2) : name;
    return name == "(none)" ? std::string() : this->Add(words[0], name, color);
  }
};

/// A table whose heading names its columns.
class Columns : public LineReader
{
public:
  Columns(const std::string& heading, char separator)
    : Separator(separator)
  {
    std::vector<std::string> names = this->CellsOf(heading);
    std::transform(names.begin(), names.end(), names.begin(),
      [](const std::string& name) { return LowerCase(Trimmed(name)); });
    const auto find = [&names](const char* name)
    {
      const auto found = std::find(names.begin(), names.end(), name);
      return found == names.end() ? Missing : static_cast<std::size_t>(found - names.begin());
    };
    this->Name = find("name");
    this->Label = find("index") == Missing ? find("labelvalue") : find("index");
    this->Code = find("color");
    this->Components = { { find("color_r"), find("color_g"), find("color_b") } };
  }

  bool HasNames() const { return this->Name != Missing && this->Label != Missing; }

  std::string Read(const std::string& line) override
  {
    const std::vector<std::string> cells = this->CellsOf(line);
    if (cells.size() <= std::max(this->Name, this->Label))
    {
      return "it has " + std::to_string(cells.size()) + " columns, fewer than its heading";
    }
    const std::string label = Trimmed(cells[this->Label]);
    const std::string name = Trimmed(cells[this->Name]);
    if (label == NotThere || name == NotThere)
    {
      return std::string();
    }
    const std::string code = this->Code < cells.size() ? Trimmed(cells[this->Code]) : std::string();
    this->HasBytes = this->HasBytes || !code.empty();
    return this->Add(label, name, code.empty() ? ColorAt(cells, this->Components) : ColorOf(code));
  }

private:
  /// Color of a text #rrggbb; nothing for another text, such as n/a.
  static std::optional<FileColor> ColorOf(const std::string& code)
  {
    FileColor color = {};
    const bool isCode = code.size() == 7 && code[0] == '#' &&
      code.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    for (std::size_t axis = 0; isCode && axis < 3; ++axis)
    {
      color[axis] = static_cast<double>(std::stoi(code.substr(1 + 2 * axis, 2), nullptr, 16));
    }
    return isCode ? std::optional<FileColor>(color) : std::nullopt;
  }

  /// A cell in quotation marks may have the separator.
  std::vector<std::string> CellsOf(const std::string& line) const
  {
    std::vector<std::string> cells(1);
    bool isQuoted = false;
    for (const char c : line)
    {
      isQuoted = isQuoted != (c == '"');
      if (c == this->Separator && !isQuoted)
      {
        cells.emplace_back();
      }
      else if (c != '"')
      {
        cells.back() += c;
      }
    }
    return cells;
  }

  char Separator;
  std::size_t Name = Missing;
  std::size_t Label = Missing;
  std::size_t Code = Missing;
  std::array<std::size_t, 3> Components{ { Missing, Missing, Missing } };
};

/// A line feed at each end, whatever it was.
std::string WithPlainLineEnds(const std::string& text)
{
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool isHalf = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (!isHalf)
    {
      plain += text[i] == '\r' ? '\n' : text[i];
    }
  }
  return plain;
}

/// By the first line that is no comment.
std::unique_ptr<LineReader> ReaderFor(const std::string& line, bool& isHeading)
{
  for (const char separator : { '\t', ',', ';' })
  {
    auto columns = std::make_unique<Columns>(line, separator);
    if (columns->HasNames())
    {
      isHeading = true;
      return columns;
    }
  }
  return std::make_unique<ColorLines>();
}
}

LabelTable ReadLabelsOfText(const std::string& text)
{
  std::unique_ptr<LineReader> reader;
  std::size_t number = 0;
  for (const std::string& line : SplitAt(WithPlainLineEnds(text), '\n'))
  {
    ++number;
    const std::size_t first = line.find_first_not_of(Blanks);
    if (first == std::string::npos || line[first] == '#')
    {
      continue;
    }
    bool isHeading = false;
    reader = reader ? std::move(reader) : ReaderFor(line, isHeading);
    const std::string problem = isHeading ? std::string() : reader->Read(line);
    if (!problem.empty())
    {
      LabelTable table;
      table.IsOther = !reader->HasLabels();
      table.Problem = "line " + std::to_string(number) + ": " + problem;
      return table;
    }
  }
  LabelTable table = reader ? reader->TakeTable() : LabelTable();
  CompleteTable(table);
  return table;
}
}
