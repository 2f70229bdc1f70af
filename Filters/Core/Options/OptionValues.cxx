// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Text.h"
#include "NumberRange.h"
#include "OptionTable.h"

#include <algorithm>
#include <type_traits>

namespace bonedecimate
{
namespace
{
template <typename Field>
using FieldType = std::decay_t<decltype(std::declval<Options>().*std::declval<Field>())>;

/// The kind of value in which a field travels: choices as int, the others as themselves.
template <typename Type>
using TravelType = std::conditional_t<std::is_enum_v<Type>, int, Type>;

std::string WithoutDashes(std::string text)
{
  text.erase(std::remove(text.begin(), text.end(), '-'), text.end());
  return text;
}

/// Reads "on", "off", "true", ... ; -1 if it is none of them.
int ReadSwitch(const std::string& text)
{
  const std::string word = LowerCase(text);
  if (word == "on" || word == "true" || word == "yes" || word == "1")
  {
    return 1;
  }
  return word == "off" || word == "false" || word == "no" || word == "0" ? 0 : -1;
}

int ReadChoice(const OptionInfo& info, const std::string& text)
{
  for (std::size_t i = 0; i < info.Choices.size(); ++i)
  {
    if (LowerCase(info.Choices[i]) == LowerCase(WithoutDashes(text)))
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

std::string Join(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

template <typename Type>
bool IsOfType(const OptionInfo& info)
{
  return std::holds_alternative<Type>(GetOption(Options{}, info));
}

/// The range of a number, or that of the numbers of a choice.
NumberRange EndsOf(const OptionInfo& info)
{
  return { info.Minimum, info.Maximum, IsOfType<int>(info), info.Unit };
}

std::string RejectionText(const OptionInfo& info, const std::string& given)
{
  return info.Name + " takes " + ValuesText(info) + ", not " + given;
}

/// A value as it stands in a sentence.
std::string TextOfValue(const OptionValue& value)
{
  if (const bool* on = std::get_if<bool>(&value))
  {
    return *on ? "on" : "off";
  }
  if (const std::string* text = std::get_if<std::string>(&value))
  {
    return "'" + *text + "'";
  }
  const int* whole = std::get_if<int>(&value);
  return whole ? std::to_string(*whole) : NumberText(std::get<double>(value));
}

std::string SetNumberFromText(Options& options, const OptionInfo& info, const std::string& text)
{
  const std::optional<double> value = ParseFinite(text);
  if (!value)
  {
    return RejectionText(info, "'" + text + "'");
  }
  if (!IsInRange(EndsOf(info), *value))
  {
    return RejectionText(info, text);
  }
  return IsOfType<int>(info) ? SetOption(options, info, static_cast<int>(*value))
                             : SetOption(options, info, *value);
}
}

std::optional<NumberRange> RangeOf(const OptionInfo& info)
{
  const bool isNumber = info.Choices.empty() && (IsOfType<int>(info) || IsOfType<double>(info));
  return isNumber ? std::optional<NumberRange>(EndsOf(info)) : std::nullopt;
}

std::string ValuesText(const OptionInfo& info)
{
  if (!info.Choices.empty())
  {
    return "one of " + Join(info.Choices);
  }
  if (IsOfType<bool>(info))
  {
    return "on or off";
  }
  return IsOfType<std::string>(info) ? "any text" : RangeText(EndsOf(info));
}

OptionValue GetOption(const Options& options, const OptionInfo& info)
{
  return std::visit(
    [&](auto field) -> OptionValue
    {
      using Type = FieldType<decltype(field)>;
      return static_cast<TravelType<Type>>(options.*field);
    },
    info.Field);
}

std::string CheckOption(const OptionInfo& info, const OptionValue& value)
{
  const int* whole = std::get_if<int>(&value);
  const double* number = std::get_if<double>(&value);
  const bool isOfKind = value.index() == GetOption(Options{}, info).index();
  const bool isNumber = isOfKind && info.Choices.empty() && (whole || number);
  if (isNumber)
  {
    return CheckNumber(info.Name, EndsOf(info), whole ? *whole : *number);
  }
  const bool isKnown = isOfKind && (!whole || IsInRange(EndsOf(info), *whole));
  return isKnown ? std::string() : RejectionText(info, TextOfValue(value));
}

std::string CheckOptions(const Options& options)
{
  for (const OptionInfo& info : OptionTable())
  {
    const std::string problem = CheckOption(info, GetOption(options, info));
    if (!problem.empty())
    {
      return problem;
    }
  }
  return {};
}

std::string SetOption(Options& options, const OptionInfo& info, const OptionValue& value)
{
  std::string problem = CheckOption(info, value);
  if (!problem.empty())
  {
    return problem;
  }
  std::visit(
    [&](auto field)
    {
      using Type = FieldType<decltype(field)>;
      options.*field = static_cast<Type>(std::get<TravelType<Type>>(value));
    },
    info.Field);
  options.TargetReductionIsExplicit =
    options.TargetReductionIsExplicit || info.Name == "TargetReduction";
  return {};
}

std::string SetOptionFromText(Options& options, const OptionInfo& info, const std::string& text)
{
  if (IsOfType<std::string>(info))
  {
    return SetOption(options, info, text);
  }
  if (!info.Choices.empty())
  {
    const int choice = ReadChoice(info, text);
    return choice < 0 ? RejectionText(info, "'" + text + "'") : SetOption(options, info, choice);
  }
  if (IsOfType<bool>(info))
  {
    const int on = ReadSwitch(text);
    return on < 0 ? RejectionText(info, "'" + text + "'") : SetOption(options, info, on == 1);
  }
  return SetNumberFromText(options, info, text);
}

std::string OptionText(const Options& options, const OptionInfo& info)
{
  const OptionValue value = GetOption(options, info);
  if (!info.Choices.empty())
  {
    return info.Choices[static_cast<std::size_t>(std::get<int>(value))];
  }
  const std::string* text = std::get_if<std::string>(&value);
  return text ? *text : TextOfValue(value);
}

std::string OptionTableMarkdown()
{
  std::string text =
    "| option | flag | values | default | unit | meaning |\n|---|---|---|---|---|---|\n";
  for (const OptionInfo& info : OptionTable())
  {
    const std::string values = IsOfType<bool>(info) ? "on, off"
      : !info.Choices.empty()                       ? Join(info.Choices)
      : IsOfType<std::string>(info)                 ? "text"
                                                    : EndsText(EndsOf(info));
    text += "| `" + info.Name + "` | " + (info.Flag.empty() ? "" : "`--" + info.Flag + "`") +
      " | " + values + " | " + OptionText(Options{}, info) + " | " + info.Unit + " | " +
      info.Sentence + " |\n";
  }
  return text;
}
}
