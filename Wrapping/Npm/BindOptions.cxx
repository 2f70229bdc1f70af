// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BindOptions.h"

#include "Options/OptionTable.h"
#include "Options/RunKinds.h"
#include "Options/UnmetNeeds.h"

#include <algorithm>
#include <cctype>

namespace bonedecimate
{
namespace
{
/// There are no data sets here, and no threads.
bool IsLeftOut(const OptionInfo& info)
{
  return !WhyUnsupported(FindRunKind("Arrays"), info).empty() ||
    !WhyUnsupported(FindRunKind("OneThread"), info).empty();
}

/// The flag of the command line in camel case: "max-error" is maxError. Without a flag the name:
/// OutputPointsGrid is outputPointsGrid.
std::string KeyOf(const OptionInfo& info)
{
  std::string key;
  bool isUpper = false;
  for (const char c : info.Flag.empty() ? info.Name : info.Flag)
  {
    if (c != '-')
    {
      key += isUpper ? static_cast<char>(std::toupper(c)) : c;
    }
    isUpper = c == '-';
  }
  key[0] = static_cast<char>(std::tolower(key[0]));
  return key;
}

const OptionInfo* FindKey(const std::string& key)
{
  const std::vector<OptionInfo>& table = OptionTable();
  const auto row = std::find_if(table.begin(), table.end(),
    [&](const OptionInfo& info) { return !IsLeftOut(info) && KeyOf(info) == key; });
  return row == table.end() ? nullptr : &*row;
}

std::string KindOf(const OptionInfo& info)
{
  const OptionValue value = GetOption(Options(), info);
  return !info.Choices.empty()                   ? "choice"
    : std::holds_alternative<bool>(value)        ? "boolean"
    : std::holds_alternative<std::string>(value) ? "string"
                                                 : "number";
}

/// Numbers and switches as they are; choices and other texts by their name. Numbers also as text:
/// "halfvoxel" is none.
std::string SetFrom(Options& options, const OptionInfo& info, const val& value)
{
  const std::string type = value.typeOf().as<std::string>();
  if (type == "string")
  {
    return SetOptionFromText(options, info, value.as<std::string>());
  }
  const bool isWhole = std::holds_alternative<int>(GetOption(options, info));
  if (type == "boolean")
  {
    return SetOption(options, info, value.as<bool>());
  }
  if (type == "number" && info.Choices.empty())
  {
    const double number = value.as<double>();
    const bool fitsInt = number ==
      static_cast<double>(
        static_cast<std::int32_t>(std::clamp(number, -2147483648.0, 2147483647.0)));
    return isWhole && fitsInt ? SetOption(options, info, static_cast<int>(number))
                              : SetOption(options, info, number);
  }
  return KeyOf(info) + " takes " + ValuesText(info);
}
}

//------------------------------------------------------------------------------
val OptionRows()
{
  val rows = val::array();
  for (const OptionInfo& info : OptionTable())
  {
    if (IsLeftOut(info))
    {
      continue;
    }
    val row = val::object();
    row.set("name", KeyOf(info));
    row.set("kind", KindOf(info));
    row.set("unit", info.Unit);
    row.set("choices", ToTexts(info.Choices));
    row.set("values", ValuesText(info));
    row.set("default", OptionText(Options(), info));
    row.set("description", info.Sentence);
    rows.call<void>("push", row);
  }
  return rows;
}

//------------------------------------------------------------------------------
std::string ReadOptions(const val& from, Options& options)
{
  options.NumberOfThreads = 1;
  const val keys = val::global("Object").call<val>("keys", from);
  std::vector<std::string> given;
  for (std::size_t i = 0; i < keys["length"].as<std::size_t>(); ++i)
  {
    const std::string key = keys[i].as<std::string>();
    const OptionInfo* info = FindKey(key);
    if (info == nullptr)
    {
      return "there is no option " + key;
    }
    if (from[key].isUndefined())
    {
      continue;
    }
    const std::string problem = SetFrom(options, *info, from[key]);
    if (!problem.empty())
    {
      return problem;
    }
    given.push_back(info->Name);
  }
  const std::vector<std::string> ineffective = UnmetNeeds(options, given);
  return ineffective.empty() ? std::string() : ineffective.front();
}
}
