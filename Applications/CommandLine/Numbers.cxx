// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"

#include "ExitCode.h"
#include "HelpFormatter.h"

#include <charconv>
#include <cmath>

namespace bonedecimate
{
namespace
{
std::vector<std::string> SplitAtCommas(const std::string& text)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == ',')
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

CLI::Option* AddText(CLI::App& app, const NumberOption& option, const std::string& accepted,
  const std::function<void(const std::string&)>& read)
{
  return app
    .add_option_function<std::string>(
      option.Flag, read, WrappedHelp(std::string(option.Help) + " Takes " + accepted + "."))
    ->type_name(option.ValueName);
}
}

std::optional<NumberRange> RangeOf(const OptionInfo& info)
{
  const OptionValue value = GetOption(Options{}, info);
  const bool isWhole = std::holds_alternative<int>(value);
  if (!info.Choices.empty() || (!isWhole && !std::holds_alternative<double>(value)))
  {
    return {};
  }
  return NumberRange{ info.Minimum, info.Maximum, isWhole, info.Unit };
}

std::optional<double> NumberFromText(const std::string& text)
{
  // from_chars takes no plus sign.
  const bool hasPlus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char* const first = text.data() + (hasPlus ? 1 : 0);
  const char* const last = text.data() + text.size();
  double value = 0.0;
  const auto read = std::from_chars(first, last, value);
  const bool isNumber = read.ec == std::errc() && read.ptr == last && std::isfinite(value);
  return isNumber ? std::optional<double>(value) : std::nullopt;
}

double ReadNumber(const std::string& flag, const std::string& text, const NumberRange& range)
{
  const std::optional<double> value = NumberFromText(text);
  if (!value || !IsInRange(range, *value))
  {
    throw Failure(ExitCode::Usage, flag + " takes " + RangeText(range) + ", not '" + text + "'");
  }
  return *value;
}

CLI::Option* AddNumber(
  CLI::App& app, const NumberOption& option, const std::function<void(double)>& set)
{
  return AddText(app, option, RangeText(option.Range),
    [option, set](const std::string& text) { set(ReadNumber(option.Flag, text, option.Range)); });
}

CLI::Option* AddNumberList(
  CLI::App& app, const NumberOption& option, const std::function<void(double)>& append)
{
  const std::string each = "numbers with commas in between, each " + RangeText(option.Range);
  return AddText(app, option, each,
    [option, append](const std::string& text)
    {
      for (const std::string& part : SplitAtCommas(text))
      {
        append(ReadNumber(option.Flag, part, option.Range));
      }
    });
}

void AddThreads(CLI::App& app, int& threads)
{
  AddNumber(app,
    { "--threads", "N", *RangeOf(*FindOption("NumberOfThreads")),
      "0, the default, is one per processor. The result does not depend on it." },
    [&threads](double value) { threads = static_cast<int>(value); });
}
}
