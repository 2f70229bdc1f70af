// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommonOptions.h"

#include "Base/Text.h"
#include "ExitCode.h"
#include "Files/FileNames.h"
#include "Formats/SurfaceFormat.h"
#include "HelpFormatter.h"
#include "Report/CountText.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>

namespace bonedecimate
{
namespace
{
constexpr double BoneValue = 226.0; // HU, a common threshold of bone in CT

/// "takes a number from 0 to 1, not '2'"; empty if nothing is wrong.
std::string Problem(const std::string& text, const NumberRange& range)
{
  const std::optional<double> value = ParseFinite(text);
  return value && IsInRange(range, *value) ? std::string()
                                           : "takes " + RangeText(range) + ", not '" + text + "'";
}

/// Without a description, which CLI11 would put behind the name of the value in the help.
CLI::Validator MakeValidator(const std::function<std::string(const std::string&)>& problem)
{
  return CLI::Validator([problem](std::string& text) { return problem(text); }, "");
}

CLI::Option* AddText(CLI::App& app, const NumberOption& option, const std::string& accepted,
  const std::function<void(const std::string&)>& read)
{
  return app
    .add_option_function<std::string>(
      option.Flag, read, WrappedHelp(std::string(option.Help) + " Takes " + accepted + "."))
    ->type_name(option.ValueName);
}

std::string ListText(const NumberRange& range)
{
  return "numbers with commas in between, each " + RangeText(range);
}
}

CLI::Validator InRange(const NumberRange& range)
{
  return MakeValidator([range](const std::string& text) { return Problem(text, range); });
}

CLI::Validator EachInRange(const NumberRange& range)
{
  return MakeValidator(
    [range](const std::string& text)
    {
      std::string problem;
      for (const std::string& part : SplitAt(text, ','))
      {
        problem = problem.empty() ? Problem(part, range) : problem;
      }
      return problem;
    });
}

CLI::Validator ValueOf(const OptionInfo& info)
{
  if (const std::optional<NumberRange> range = RangeOf(info))
  {
    return InRange(*range);
  }
  return MakeValidator(
    [&info](const std::string& text)
    {
      Options ignored;
      const bool isValid = SetOptionFromText(ignored, info, text).empty();
      return isValid ? std::string() : "takes " + ValuesText(info) + ", not '" + text + "'";
    });
}

CLI::Validator OneOf(const std::string& choices)
{
  return CLI::Validator(
    [choices](std::string& text)
    {
      const std::vector<std::string> words = SplitAt(choices, '|');
      const auto found = std::find_if(words.begin(), words.end(),
        [&text](const std::string& word) { return LowerCase(word) == LowerCase(text); });
      if (found == words.end())
      {
        const std::string listed = CLI::detail::join(words, words.size() == 2 ? " or " : ", ");
        return "takes " + (words.size() > 2 ? "one of " + listed : listed) + ", not '" + text + "'";
      }
      text = *found;
      return std::string();
    },
    "");
}

double ReadNumber(const std::string& flag, const std::string& text, const NumberRange& range)
{
  const std::string problem = Problem(text, range);
  if (!problem.empty())
  {
    throw Failure(ExitCode::Usage, flag + " " + problem);
  }
  return *ParseFinite(text);
}

CLI::Option* AddNumber(
  CLI::App& app, const NumberOption& option, const std::function<void(double)>& set)
{
  return AddText(app, option, RangeText(option.Range),
    [set](const std::string& text) { set(*ParseFinite(text)); })
    ->check(InRange(option.Range));
}

void AddIsoValue(CLI::App& app, const std::function<void(double)>& set, const std::string& help)
{
  const auto number = [](const std::string& text)
  { return LowerCase(text) == "bone" ? std::optional<double>(BoneValue) : ParseFinite(text); };
  app
    .add_option_function<std::string>(
      "--iso", [set, number](const std::string& text) { set(*number(text)); },
      WrappedHelp(help + " Takes " + RangeText(HounsfieldRange) + "; bone is 226 HU."))
    ->type_name("HU|bone")
    ->check(CLI::Validator(
      [number](std::string& text)
      {
        const std::optional<double> value = number(text);
        return value && IsInRange(HounsfieldRange, *value)
          ? std::string()
          : "takes " + RangeText(HounsfieldRange) + ", or bone, not '" + text + "'";
      },
      ""));
}

CLI::Option* AddNumberList(
  CLI::App& app, const NumberOption& option, const std::function<void(double)>& append)
{
  return AddText(app, option, ListText(option.Range),
    [append](const std::string& text)
    {
      for (const std::string& part : SplitAt(text, ','))
      {
        append(*ParseFinite(part));
      }
    })
    ->check(EachInRange(option.Range));
}

void AddFile(
  CLI::App& app, const char* flag, const char* kind, std::string& value, const char* help)
{
  app.add_option(flag, value, WrappedHelp(help))->type_name(kind);
}

void AddSwitch(
  CLI::App& app, const char* flag, const std::function<void(bool)>& set, const char* help)
{
  app
    .add_option_function<std::string>(
      flag, [set](const std::string& text) { set(text == "on"); }, WrappedHelp(help))
    ->type_name("on|off")
    ->check(OneOf("on|off"));
}

void AddSurfaces(CLI::App& app, std::vector<std::string>& files, const std::string& what)
{
  app
    .add_option(
      "SURFACES", files, WrappedHelp(what + " (" + SurfaceExtensions() + "), in mm or --unit."))
    ->type_name("")
    ->allow_extra_args();
}

void RequireFiles(const CLI::App& command, const std::vector<std::string>& files, std::size_t count,
  const std::string& what)
{
  if (files.size() != count)
  {
    throw Failure(ExitCode::Usage,
      command.get_name() + " takes " + what + "; " + ThereAreText(files.size(), "file"));
  }
}

void RequireExtension(
  const std::string& flag, const std::string& path, const std::vector<std::string>& extensions)
{
  const std::string extension = ExtensionOf(path);
  if (!extension.empty() &&
    std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
  {
    throw Failure(
      ExitCode::Usage, flag + " '" + path + "' needs the extension " + extensions.front());
  }
}

std::string DefaultMode()
{
  return FindMode(Options().Mode).Name;
}

void AddMode(CLI::App& app, std::string& mode, const std::string& choices, const std::string& help)
{
  app.add_option("--mode", mode, help)->type_name(choices)->check(OneOf(choices));
}

void AddThreads(CLI::App& app, int& threads)
{
  AddNumber(app,
    { "--threads", "N", *RangeOf(*FindOption("NumberOfThreads")),
      "0, the default, is one per processor. The result does not depend on it." },
    [&threads](double value) { threads = static_cast<int>(value); });
}

void AddQuiet(CLI::App& app, bool& quiet)
{
  app.add_flag(
    "--quiet", quiet, "Nothing on the standard output; failures, on the standard error.");
}

void AddAllowLargeError(CLI::App& app, bool& allow)
{
  AddSwitch(
    app, "--allow-large-error", [&allow](bool on) { allow = on; },
    "Take an error of more than a quarter of the diagonal of the input's bounding box, which is "
    "rejected otherwise; default off.");
}
}
