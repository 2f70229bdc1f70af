// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels/LabelTable.h"

#include "Base/Text.h"
#include "PlainText.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::json;

/// With question marks for bytes that are no UTF-8.
std::string ValidText(std::string text)
{
  for (std::size_t i = 0; i < text.size();)
  {
    const bool isAscii = static_cast<unsigned char>(text[i]) < 0x80;
    const std::size_t length =
      isAscii ? 1 : LengthOfPlainCharacter(std::string_view(text).substr(i));
    text[i] = length == 0 ? '?' : text[i];
    i += std::max<std::size_t>(length, 1);
  }
  return text;
}

/// A whole number, also one that is written as 1.0 or "1".
std::optional<std::int64_t> LabelOf(const Json& value)
{
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > std::uint64_t(INT64_MAX))
  {
    return std::nullopt;
  }
  if (value.is_number_integer())
  {
    return value.get<std::int64_t>();
  }
  if (value.is_string())
  {
    return ParseNumber<std::int64_t>(value.get_ref<const std::string&>());
  }
  constexpr double most = 9007199254740992.0;
  const double number = value.is_number_float() ? value.get<double>() : most;
  const bool isWhole = std::abs(number) < most && !(std::floor(number) < number);
  return isWhole ? std::optional<std::int64_t>(static_cast<std::int64_t>(number)) : std::nullopt;
}

std::string ProblemOf(const std::string& name, const Json& value)
{
  const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  return "the label of '" + PlainText(name.substr(0, LongestQuote)) + "' is " +
    text.substr(0, LongestQuote) + ", which is no whole number and no list of them";
}

/// Name and number, or name and list.
std::string Add(const std::string& name, const Json& value, LabelTable& table)
{
  std::vector<std::int64_t> labels;
  for (const Json& one : value.is_array() ? value : Json::array({ value }))
  {
    const std::optional<std::int64_t> label = LabelOf(one);
    if (!label)
    {
      return ProblemOf(name, value);
    }
    labels.push_back(*label);
  }
  if (labels.size() == 1)
  {
    table.Labels.push_back({ labels.front(), name, {} });
  }
  else if (!labels.empty())
  {
    table.Regions[LowerCase(PlainText(name))] = labels;
  }
  return std::string();
}
}

LabelTable ReadLabelsOfJson(const std::string& text)
{
  LabelTable table;
  const Json json = Json::parse(ValidText(text), nullptr, false);
  if (json.is_discarded())
  {
    table.Problem = "it is no valid JSON";
    return table;
  }
  const auto labels = json.find("labels");
  if (labels == json.end())
  {
    return table;
  }
  if (!labels->is_object())
  {
    table.Problem = "its entry labels is no object with a number for each name";
    return table;
  }
  for (const auto& [name, value] : labels->items())
  {
    const auto number = ParseNumber<std::int64_t>(name);
    const bool isReversed = number && value.is_string() && !LabelOf(value);
    if (isReversed)
    {
      table.Labels.push_back({ *number, value.get<std::string>(), {} });
    }
    else if (table.Problem.empty())
    {
      table.Problem = Add(name, value, table);
    }
  }
  if (table.Problem.empty())
  {
    CompleteTable(table);
  }
  return table;
}
}
