// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandWords.h"

#include "ExitCode.h"
#include "HelpFormatter.h"
#include "NearestWord.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <set>

namespace bonedecimate
{
namespace
{
/// Dashes and a letter; a dash and a digit are a number.
bool IsOption(const std::string& word)
{
  const std::size_t begin = word.find_first_not_of('-');
  return begin != 0 && begin != std::string::npos &&
    std::isalpha(static_cast<unsigned char>(word[begin])) != 0;
}

/// Two dashes alone end the options.
bool IsValue(const std::string& word)
{
  return word != "--" && (word.rfind("--", 0) != 0 || !IsOption(word));
}

/// Names of the options that --help lists, without dashes.
std::vector<std::string> OptionNames(const CLI::App& command)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
  {
    if (!option->get_group().empty())
    {
      const std::vector<std::string>& own = option->get_lnames();
      names.insert(names.end(), own.begin(), own.end());
    }
  }
  return names;
}

[[noreturn]] void RejectUnknown(const CLI::App& command, const std::string& word)
{
  const std::string name = word.substr(0, word.find('='));
  const std::string plain = name.substr(name.find_first_not_of('-'));
  const std::vector<std::string> known = OptionNames(command);
  const bool isOther = plain == "tolerance" || plain == "max-error"; // the same in two commands
  const std::string other = plain == "tolerance" ? "max-error" : "tolerance";
  const bool hasOther = isOther && std::find(known.begin(), known.end(), other) != known.end();
  std::string meant;
  for (const std::string& similar :
    hasOther ? std::vector<std::string>{ other } : SimilarNames(plain, known))
  {
    meant += (meant.empty() ? "--" : " or --") + similar;
  }
  throw Failure(ExitCode::Usage,
    "unknown option " + name +
      (meant.empty() ? "; see " + CommandPath(command) + " -h" : "; did you mean " + meant + "?"));
}

/// A word processor makes a dash of two hyphens: U+2010 to U+2015 and U+2212 in UTF-8.
bool BeginsWithDash(const std::string& word)
{
  const std::string first = word.substr(0, 3);
  return (first >= "\xe2\x80\x90" && first <= "\xe2\x80\x95") || first == "\xe2\x88\x92";
}

/// CLI11 takes any word for the value of an option, another option, too.
void RequireValue(
  const CLI::App& command, const CLI::Option& option, const std::string& word, bool hasValue)
{
  if (option.get_items_expected_min() > 0 && !hasValue)
  {
    throw Failure(ExitCode::Usage,
      word + " takes a value: " + option.get_type_name() + "; see " + CommandPath(command) + " -h");
  }
}
}

void RequireOptions(const CLI::App& command, const std::vector<std::string>& words)
{
  std::set<const CLI::Option*> given;
  for (std::size_t i = 1; i < words.size() && words[i] != "--"; ++i)
  {
    if (BeginsWithDash(words[i]))
    {
      throw Failure(ExitCode::Usage,
        "'" + words[i] +
          "' begins with a dash; options begin with two hyphens, as --max-error does");
    }
    if (!IsOption(words[i]))
    {
      continue;
    }
    const std::string name = words[i].substr(0, words[i].find('='));
    const CLI::Option* const option = command.get_option_no_throw(name);
    if (option == nullptr)
    {
      RejectUnknown(command, words[i]);
    }
    const bool takesValue = option->get_items_expected_max() > 0;
    const bool isOneWord = name.size() < words[i].size();
    RequireValue(
      command, *option, words[i], isOneWord || (i + 1 < words.size() && IsValue(words[i + 1])));
    if (isOneWord && !takesValue)
    {
      throw Failure(ExitCode::Usage, name + " takes no value");
    }
    const bool isRepeated = !given.insert(option).second;
    if (isRepeated && option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw)
    {
      throw Failure(ExitCode::Usage, name + " is given more than once");
    }
    i += takesValue && !isOneWord ? 1 : 0;
  }
}
}
