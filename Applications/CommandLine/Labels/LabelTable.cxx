// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels/LabelTable.h"

#include "FilePath.h"
#include "PlainText.h"
#include "Readers/DataFile.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace bonedecimate
{
namespace
{
constexpr std::uint64_t LargestFile = std::uint64_t(1) << 26;

std::string ProblemOf(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(FilePath(path), error))
  {
    return "it is not there or is no regular file";
  }
  return volume::SizeOfFile(path) > LargestFile
    ? "it is larger than 64 MB, which no table of labels is"
    : std::string();
}
}

LabelTable ReadLabelTable(const std::string& path)
{
  LabelTable table;
  table.Problem = ProblemOf(path);
  if (!table.Problem.empty())
  {
    return table;
  }
  std::ifstream file(FilePath(path), std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file.good() && !file.eof())
  {
    table.Problem = "it could not be read";
    return table;
  }
  if (text.compare(0, 2, "\xff\xfe") == 0 || text.compare(0, 2, "\xfe\xff") == 0)
  {
    table.Problem = "its text is UTF-16; save it as UTF-8";
    return table;
  }
  text.erase(0, text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool isJson = first != std::string::npos && text[first] == '{';
  return isJson ? ReadLabelsOfJson(text) : ReadLabelsOfText(text);
}

void CompleteTable(LabelTable& table)
{
  std::vector<NamedLabel>& labels = table.Labels;
  labels.erase(std::remove_if(labels.begin(), labels.end(),
                 [](const NamedLabel& label) { return label.Value == 0; }),
    labels.end());
  for (NamedLabel& label : labels)
  {
    label.Name = PlainText(label.Name);
  }
  std::stable_sort(labels.begin(), labels.end(),
    [](const NamedLabel& a, const NamedLabel& b) { return a.Value < b.Value; });
  const auto isSame = [](const NamedLabel& a, const NamedLabel& b) { return a.Value == b.Value; };
  const auto isOther = [isSame](const NamedLabel& a, const NamedLabel& b)
  { return isSame(a, b) && a.Name != b.Name; };
  const auto other = std::adjacent_find(labels.begin(), labels.end(), isOther);
  if (other != labels.end())
  {
    table.Problem = "its label " + std::to_string(other->Value) + " has two names, '" +
      other->Name + "' and '" + (other + 1)->Name + "'";
  }
  labels.erase(std::unique(labels.begin(), labels.end(), isSame), labels.end());
}
}
