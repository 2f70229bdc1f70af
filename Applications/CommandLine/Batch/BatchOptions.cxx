// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchOptions.h"

#include "Base/Parallel.h"
#include "BoneVolume.h"
#include "Options/OptionTable.h"
#include "Settings/Settings.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
bool HasNumberOfThreads(const Arguments& arguments)
{
  return arguments.Given.count(FindOption("NumberOfThreads")->Flag) > 0;
}
}

std::map<std::string, std::string> OptionsFor(const BatchBone& bone, const Arguments& arguments)
{
  std::map<std::string, std::string> given = arguments.Given;
  if (!bone.Volume)
  {
    for (const char* ofVolumes :
      { "iso", "intensities", "segments", "label-names", "format", "fill-volume", "model-grid" })
    {
      given.erase(ofVolumes);
    }
  }
  if (!NeedsSpacing(bone.Input))
  {
    given.erase("spacing");
  }
  if (!HasSeries(bone.Input))
  {
    given.erase("series");
  }
  return given;
}

std::vector<std::string> WordsFor(const BatchBone& bone, const Arguments& arguments)
{
  std::vector<std::string> words = { "--quiet", "--report", bone.Report };
  for (const auto& [flag, text] : OptionsFor(bone, arguments))
  {
    words.insert(words.end(), { "--" + flag, text });
  }
  const unsigned int jobs = static_cast<unsigned int>(std::max(arguments.Jobs, 1));
  if (jobs > 1 && !HasNumberOfThreads(arguments))
  {
    const unsigned int threads = std::max(1U, NumberOfProcessors() / jobs);
    words.insert(
      words.end(), { "--" + FindOption("NumberOfThreads")->Flag, std::to_string(threads) });
  }
  const std::vector<std::string> settings = WordsOfSettings(arguments.Settings);
  words.insert(words.end(), settings.begin(), settings.end());
  words.insert(words.end(), { "--", bone.Input, bone.Output });
  return words;
}

std::string OptionsText(const Arguments& arguments)
{
  std::string text = OptionsText(arguments.Given);
  for (const std::string& word : WordsOfSettings(arguments.Settings))
  {
    text.append(text.empty() ? "" : " ").append(word);
  }
  return text;
}

bool HasDefaultTarget(const Arguments& arguments)
{
  const auto flags = { "max-error", "preset", "region", "target-reduction", "target-triangles",
    "tolerance-array" };
  return std::none_of(flags.begin(), flags.end(),
    [&arguments](const char* flag) { return arguments.Given.count(flag) > 0; });
}
}
