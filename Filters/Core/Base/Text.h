// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Text.h
 * @brief Text in options and files: case, lists, XML, numbers. The same in every locale.
 */
#ifndef BoneDecimate_Core_Base_Text_h
#define BoneDecimate_Core_Base_Text_h

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace bonedecimate
{
/// Replaces A to Z; letters beyond ASCII stay as they are.
inline std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

/// The parts between the separators, including empty ones. An empty text has one empty part.
inline std::vector<std::string> SplitAt(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

/// Text such as "1, 2, 3, 4, 5 and 17 more". @param textOf The text of an item.
template <typename Item, typename TextOf>
std::string ShortList(const std::vector<Item>& items, TextOf textOf)
{
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(items.size(), most); ++i)
  {
    text += (i > 0 ? ", " : "") + textOf(items[i]);
  }
  return items.size() > most ? text + " and " + std::to_string(items.size() - most) + " more"
                             : text;
}

/// "1, 2, 3, 4, 5 and 17 more".
template <typename Number>
std::string ListText(const std::vector<Number>& numbers)
{
  return ShortList(numbers, [](Number number) { return std::to_string(number); });
}

/// "'a', 'b'"; "none" if there are none.
inline std::string QuotedList(const std::vector<std::string>& names)
{
  return names.empty() ? "none"
                       : ShortList(names, [](const std::string& name) { return "'" + name + "'"; });
}

/// Escapes text or an attribute value for XML, HTML or SVG.
inline std::string EscapedXml(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    switch (c)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

#ifdef __cpp_lib_to_chars
template <typename Number>
std::from_chars_result ReadNumber(const char* first, const char* last, Number& value)
{
  return std::from_chars(first, last, value);
}
#else
/// Replaces from_chars of standard libraries that read only whole numbers.
template <typename Number>
std::from_chars_result ReadNumber(const char* first, const char* last, Number& value)
{
  if constexpr (std::is_floating_point_v<Number>)
  {
    const std::string text(first, last);
    // strtod also skips blanks and reads hexadecimal digits and nan(...).
    const bool isPlain = !text.empty() && text[0] != '+' &&
      text.find_first_not_of("0123456789.eE+-infatyINFATY") == std::string::npos;
    char* end = nullptr;
    value = isPlain ? std::strtod(text.c_str(), &end) : 0.0;
    const std::ptrdiff_t used = isPlain ? end - text.c_str() : 0;
    return { first + used, used == 0 ? std::errc::invalid_argument : std::errc() };
  }
  else
  {
    return std::from_chars(first, last, value);
  }
}
#endif

/**
 * Reads a text that is a decimal number as a whole: no blanks, unit, hexadecimal digits or comma; a
 * plus sign is allowed. Doubles are rounded to the nearest; those beyond the largest are infinite.
 * The words nan, inf and infinity are numbers.
 * @returns Nothing for any other text, and for a whole number out of range.
 */
template <typename Number>
std::optional<Number> ParseNumber(std::string_view text)
{
  // from_chars takes no plus sign.
  const bool hasPlus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
  const char* const first = text.data() + (hasPlus ? 1 : 0);
  const char* const last = text.data() + text.size();
  Number value = {};
  const std::from_chars_result read = ReadNumber(first, last, value);
  if (read.ec == std::errc::invalid_argument || read.ptr != last)
  {
    return {};
  }
  if (read.ec == std::errc::result_out_of_range)
  {
    if constexpr (std::is_floating_point_v<Number>)
    {
      return static_cast<Number>(std::strtod(std::string(first, last).c_str(), nullptr));
    }
    return {};
  }
  return value;
}

/// ParseNumber() for a finite double; nothing for a number that rounds to 0, because 0 often
/// switches an option off.
inline std::optional<double> ParseFinite(std::string_view text)
{
  const std::optional<double> value = ParseNumber<double>(text);
  const bool isZero = text.find_first_of("123456789") >= text.find_first_of("eE");
  return value && std::isfinite(*value) && (*value != 0.0 || isZero) ? value : std::nullopt;
}
}

#endif
