// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HelpFormatter.h"

#include "ExitCode.h"
#include "Numbers.h"
#include "SurfaceFormat.h"

#include <sstream>

namespace bonedecimate
{
namespace
{
constexpr std::size_t FlagColumn = 32;
constexpr std::size_t TextWidth = 68;

/// "a number, 0 to 1"; of choices as the table itself puts it when it refuses a text.
std::string AcceptedValues(const OptionInfo& info)
{
  if (const std::optional<NumberRange> range = RangeOf(info))
  {
    return RangeText(*range);
  }
  Options ignored;
  const std::string problem = SetOptionFromText(ignored, info, "?");
  const std::string before = " takes ";
  const std::size_t begin = problem.find(before);
  const std::size_t end = problem.rfind(", not '");
  return begin == std::string::npos || end == std::string::npos
    ? "any text"
    : problem.substr(begin + before.size(), end - begin - before.size());
}
}

HelpFormatter::HelpFormatter(const std::string& usage)
  : Usage(usage)
{
  this->column_width(FlagColumn);
}

std::string HelpFormatter::make_usage(const CLI::App* app, std::string) const
{
  return "Usage: " + app->get_name() + " " + this->Usage + "\n";
}

std::string ProgramDescription()
{
  return "Makes a bone surface from CT smaller, keeps every fragment and says in millimetres what "
         "that cost.";
}

std::string HelpFooter()
{
  return std::string("Surfaces are read and written by extension: ") + SurfaceExtensions +
    ".\n"
    "Of them vtp and vtk hold arrays. Every file is written whole or not at all.\n"
    "Lengths are millimetres.\n\n"
    "Many bones: the output folder gets NAME.EXT and NAME.json for each, and summary.csv.\n"
    "NAME is the input's, with its extension, its folder or a number added where two inputs\n"
    "would get the same. One that fails does not stop the others. Files of a folder that are\n"
    "no surfaces or volumes are skipped, each with a row in summary.csv. Run again, a bone is\n"
    "skipped if its report names the same version, options, input size and time of change,\n"
    "and its output has the size it was written with. The program ends with the highest\n"
    "code of them; a bone whose process died counts as 5, a volume in a folder without --iso\n"
    "as 2, a file of another kind that was not named itself as 0.\n\n" +
    ExitCodesText() + "\nThis software is not a medical device.\n";
}

std::string OptionValueName(const OptionInfo& info)
{
  if (!info.Choices.empty())
  {
    std::string names;
    for (const std::string& choice : info.Choices)
    {
      names += (names.empty() ? "" : "|") + choice;
    }
    return names;
  }
  const OptionValue value = GetOption(Options{}, info);
  if (std::holds_alternative<bool>(value))
  {
    return "on|off";
  }
  if (info.Unit == "mm")
  {
    return "MM";
  }
  return std::holds_alternative<int>(value)      ? "N"
    : std::holds_alternative<std::string>(value) ? "NAME"
                                                 : "NUMBER";
}

std::string OptionHelp(const OptionInfo& info)
{
  const std::string byDefault = OptionText(Options{}, info);
  return WrappedHelp(info.Sentence + " Takes " + AcceptedValues(info) + "; default " +
    (byDefault.empty() ? "none" : byDefault) + ".");
}

std::string WrappedHelp(const std::string& text)
{
  std::istringstream words(text);
  std::string wrapped;
  std::size_t width = 0;
  for (std::string word; words >> word; width += word.size())
  {
    const bool breaks = width > 0 && width + 1 + word.size() > TextWidth;
    wrapped += breaks ? "\n" : (width > 0 ? " " : "");
    width = breaks ? 0 : width + (width > 0 ? 1 : 0);
    wrapped += word;
  }
  return wrapped;
}
}
