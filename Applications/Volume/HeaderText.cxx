// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeaderText.h"

#include "Options/Text.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace bonedecimate::volume
{
namespace
{
/// Headers are a page; some programs add a dump of the DICOM header. A binary file without line
/// ends stops here.
constexpr std::size_t LongestHeader = std::size_t(1) << 22;

std::string ReadBeginning(const std::string& path)
{
  std::string text(LongestHeader, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

/// Lines that are no fields (comments, anything else) are passed over.
void AddField(const std::string& line, char separator, HeaderText& header)
{
  const std::size_t position = line.find(separator);
  const bool isPair = separator == ':' && line.compare(position + 1, 1, "=") == 0;
  if (position == std::string::npos || line[0] == '#')
  {
    return;
  }
  if (isPair)
  {
    header.PairKeys.insert(LowerCase(Trimmed(line.substr(0, position))));
  }
  else
  {
    header.Fields[LowerCase(Trimmed(line.substr(0, position)))] =
      Trimmed(line.substr(position + 1));
  }
}

template <typename Number>
std::optional<std::vector<Number>> Parse(const std::string& text)
{
  const std::string between = " \t\r\n,()\\";
  std::vector<Number> numbers;
  std::size_t first = text.find_first_not_of(between);
  while (first != std::string::npos)
  {
    const std::size_t end = std::min(text.find_first_of(between, first), text.size());
    const auto number = ParseNumber<Number>(std::string_view(text).substr(first, end - first));
    if (!number)
    {
      return std::nullopt;
    }
    numbers.push_back(*number);
    first = text.find_first_not_of(between, end);
  }
  return numbers;
}
}

std::string HeaderText::Value(const std::vector<std::string>& keys) const
{
  for (const std::string& key : keys)
  {
    const auto found = this->Fields.find(key);
    if (found != this->Fields.end())
    {
      return found->second;
    }
  }
  return std::string();
}

HeaderText ReadHeaderText(const std::string& path, const HeaderSyntax& syntax)
{
  HeaderText header;
  const std::string text = ReadBeginning(path);
  if (text.compare(0, syntax.Magic.size(), syntax.Magic) != 0)
  {
    header.Problem = "it does not begin like a file of its kind";
    return header;
  }
  std::size_t begin = syntax.Magic.empty() ? 0 : std::min(text.find('\n'), text.size() - 1) + 1;
  const bool endsEmpty = syntax.LastBucket.empty();
  bool isOver = false;
  while (!isOver && begin < text.size())
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = Trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    isOver = endsEmpty && line.empty();
    if (!line.empty())
    {
      AddField(line, syntax.Separator, header);
      isOver = isOver || (!endsEmpty && header.Fields.count(syntax.LastBucket) > 0);
    }
  }
  header.End = static_cast<std::int64_t>(std::min(begin, text.size()));
  // A header of NRRD may end with its file: then the voxels lie in another file.
  if (!isOver && (!endsEmpty || text.size() == LongestHeader))
  {
    header.Problem = "its header has no end";
  }
  return header;
}

std::string Trimmed(const std::string& text)
{
  const std::string blanks(" \t\r\n\0", 5);
  const std::size_t first = text.find_first_not_of(blanks);
  const std::size_t last = text.find_last_not_of(blanks);
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

std::optional<std::vector<double>> ParseNumbers(const std::string& text)
{
  return Parse<double>(text);
}

std::optional<std::vector<std::int64_t>> ParseWholeNumbers(const std::string& text)
{
  return Parse<std::int64_t>(text);
}

std::string BesideHeader(const std::string& headerPath, const std::string& dataFile)
{
  return (std::filesystem::path(headerPath).parent_path() / dataFile).string();
}
}
