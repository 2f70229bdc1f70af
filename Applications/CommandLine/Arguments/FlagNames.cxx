// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlagNames.h"

#include "Options/OptionTable.h"

#include <cctype>
#include <map>

namespace bonedecimate
{
namespace
{
/// Flags by the names of their properties.
std::map<std::string, std::string> MakeFlags()
{
  std::map<std::string, std::string> flags = { { "Label", "--label" } };
  for (const OptionInfo& info : OptionTable())
  {
    if (!info.Flag.empty())
    {
      flags[info.Name] = "--" + info.Flag;
    }
  }
  return flags;
}

bool IsBegin(const std::string& text, std::size_t at)
{
  return at == 0 || text[at - 1] == ' ' || text[at - 1] == '(';
}

/// A period ends a word only where a blank follows, unlike in the name of a file.
bool IsEnd(const std::string& text, std::size_t at)
{
  const std::size_t next = text.find_first_not_of(".,;:)", at);
  return next == std::string::npos || text[next] == ' ' || text[next] == '\n';
}
}

std::string WithFlags(const std::string& sentence)
{
  static const std::map<std::string, std::string> flags = MakeFlags();
  std::string text;
  for (std::size_t at = 0; at < sentence.size();)
  {
    std::size_t end = at;
    while (end < sentence.size() && std::isalpha(static_cast<unsigned char>(sentence[end])) != 0)
    {
      ++end;
    }
    const std::string word = sentence.substr(at, end - at);
    const auto found = flags.find(word);
    const bool isProperty = found != flags.end() && IsBegin(sentence, at) && IsEnd(sentence, end);
    text += isProperty ? found->second : word;
    text += end < sentence.size() ? std::string(1, sentence[end]) : std::string();
    at = end + 1;
  }
  return text;
}
}
