// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnmetNeeds.h"

#include "OptionTable.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// "EdgeLength and Mode Fast"; with a comma after a part that is a list itself.
std::string JoinedWords(const NeedList& needs)
{
  std::string text;
  for (const Need need : needs)
  {
    if (const NeedInfo* info = FindNeed(need))
    {
      const bool isList =
        text.find(',') != std::string::npos || text.find(" or ") != std::string::npos;
      text += (text.empty() ? "" : isList ? ", and " : " and ") + info->Words;
    }
  }
  return text;
}

bool IsMet(const Options& options, const NeedList& needs)
{
  return std::all_of(needs.begin(), needs.end(),
    [&options](Need need)
    {
      const NeedInfo* info = FindNeed(need);
      return info == nullptr || info->IsMet(options);
    });
}

/// Whether it is a number that its default, 0, turns off.
bool IsOff(const Options& options, const OptionInfo& info)
{
  const OptionValue value = GetOption(options, info);
  const bool isZero = value == OptionValue(0) || value == OptionValue(0.0);
  return info.Choices.empty() && isZero && value == GetOption(Options{}, info);
}
}

std::vector<std::string> UnmetNeeds(const Options& options, const std::vector<std::string>& given)
{
  std::vector<std::string> sentences;
  for (const OptionInfo& info : OptionTable())
  {
    if (std::find(given.begin(), given.end(), info.Name) == given.end() || IsOff(options, info))
    {
      continue;
    }
    for (const NeedList& needs : info.Needs)
    {
      if (!IsMet(options, needs))
      {
        sentences.push_back(info.Name + " has no effect; it needs " + JoinedWords(needs));
      }
    }
  }
  return sentences;
}
}
