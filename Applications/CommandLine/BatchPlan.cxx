// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchPlan.h"

#include "BoneVolume.h"
#include "ExitCode.h"
#include "FileNames.h"
#include "Formats/SurfaceFormat.h"
#include "Options/OptionTable.h"
#include "Options/Text.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <thread>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
bool TakesVolumes(const Arguments& arguments)
{
  return arguments.Iso || arguments.Segments.IsRequested();
}

/// An entry of a folder that was scanned, with the reason if it is no bone.
BatchBone BoneOf(const fs::path& path, bool takesVolumes)
{
  std::error_code error;
  BatchBone bone;
  bone.Input = path.string();
  const bool isFolder = fs::is_directory(path, error);
  bone.Volume = IsVolume(bone.Input);
  if (bone.Volume && !takesVolumes)
  {
    bone.WhyNot = "a volume: --iso HU or, of a label map, --segments says which surface to take";
    bone.CodeIfNot = ExitCode::InputRejected;
  }
  else if (!bone.Volume && isFolder)
  {
    bone.WhyNot = "a folder: folders in a folder are not searched";
  }
  else if (!bone.Volume && FindFormat(bone.Input) == nullptr)
  {
    const std::string extension = path.extension().string();
    bone.WhyNot = "not a surface or volume: " + (extension.empty() ? "no extension" : extension);
  }
  return bone;
}

void AddFolder(std::vector<BatchBone>& bones, const std::string& folder, const Arguments& arguments)
{
  std::vector<fs::path> paths;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
  {
    paths.push_back(entry.path());
  }
  if (error)
  {
    throw Failure(ExitCode::InputRejected, "'" + folder + "' was rejected: " + error.message());
  }
  std::sort(paths.begin(), paths.end());
  for (const fs::path& path : paths)
  {
    const bool isHidden = path.filename().string()[0] == '.';
    if (!isHidden && !fs::equivalent(path, arguments.Output, error))
    {
      bones.push_back(BoneOf(path, TakesVolumes(arguments)));
    }
  }
}

/// How much of an input's path goes into its name, from little to all that is there.
std::string NameOf(const fs::path& input, int detail)
{
  const fs::path file = input.has_filename() ? input : input.parent_path();
  // "ct.nii.gz" is "ct".
  std::string name = file.stem().string();
  name = ExtensionOf(file.string()) == "gz" ? fs::path(name).stem().string() : name;
  if (detail > 0)
  {
    name += "_" + ExtensionOf(file.string());
  }
  return detail > 1 ? fs::absolute(file).parent_path().filename().string() + "_" + name : name;
}

/// Two inputs of one name get more of their paths into it, in the end a number. Small and capital
/// letters are the same here, for there are file systems that think so.
void NameBones(const std::vector<BatchBone*>& bones)
{
  for (int detail = 0; detail <= 2; ++detail)
  {
    std::multiset<std::string> names;
    for (const BatchBone* bone : bones)
    {
      names.insert(LowerCase(bone->Name));
    }
    for (BatchBone* bone : bones)
    {
      if (bone->Name.empty() || names.count(LowerCase(bone->Name)) > 1)
      {
        bone->Name = NameOf(bone->Input, detail);
      }
    }
  }
  std::set<std::string> taken;
  for (BatchBone* bone : bones)
  {
    const std::string name = bone->Name;
    for (int number = 2; !taken.insert(LowerCase(bone->Name)).second; ++number)
    {
      bone->Name = name + "_" + std::to_string(number);
    }
  }
}

/// What is no bone keeps its own name and does not change that of any output.
void NameAll(std::vector<BatchBone>& all)
{
  std::vector<BatchBone*> bones;
  for (BatchBone& one : all)
  {
    if (one.IsBone())
    {
      bones.push_back(&one);
    }
    else
    {
      one.Name = BaseName(one.Input);
    }
  }
  NameBones(bones);
}

std::string OutputExtension(const BatchBone& bone, const Arguments& arguments)
{
  if (!arguments.Format.empty())
  {
    return LowerCase(arguments.Format);
  }
  return bone.Volume || FindFormat(bone.Input) == nullptr ? "vtp" : ExtensionOf(bone.Input);
}

void CheckThatThereAreBones(const std::vector<BatchBone>& bones, const Arguments& arguments)
{
  const auto isBone = [](const BatchBone& bone) { return bone.IsBone(); };
  if (std::none_of(bones.begin(), bones.end(), isBone))
  {
    throw Failure(ExitCode::InputRejected,
      "'" + arguments.Inputs[0] + "' was rejected: no surface file is in it" +
        (TakesVolumes(arguments) ? " and no volume" : ", and volumes need --iso HU or --segments"));
  }
  const auto isVolume = [](const BatchBone& bone) { return bone.Volume; };
  if (arguments.Iso && std::none_of(bones.begin(), bones.end(), isVolume))
  {
    throw Failure(ExitCode::Usage, "--iso is for volumes; none of the inputs is one");
  }
  if (arguments.Segments.IsRequested() && std::none_of(bones.begin(), bones.end(), isVolume))
  {
    throw Failure(ExitCode::Usage, "--segments is for label maps; none of the inputs is one");
  }
}

void CheckOverwriting(const std::vector<BatchBone>& bones)
{
  for (const BatchBone& bone : bones)
  {
    for (const BatchBone& other : bones)
    {
      std::error_code error;
      if (bone.IsBone() && fs::equivalent(bone.Output, other.Input, error))
      {
        throw Failure(ExitCode::Usage, "'" + bone.Output + "' is an input; it is not overwritten");
      }
    }
  }
}

bool HasNumberOfThreads(const Arguments& arguments)
{
  return arguments.Given.count(FindOption("NumberOfThreads")->Flag) > 0;
}
}

std::vector<BatchBone> PlanBatch(const Arguments& arguments)
{
  std::vector<BatchBone> bones;
  for (const std::string& input : arguments.Inputs)
  {
    std::error_code error;
    const bool volume = IsVolume(input);
    if (!volume && fs::is_directory(input, error))
    {
      AddFolder(bones, input, arguments);
    }
    else
    {
      BatchBone bone;
      bone.Input = input;
      bone.Volume = volume;
      bones.push_back(bone);
    }
  }
  CheckThatThereAreBones(bones, arguments);
  NameAll(bones);
  for (BatchBone& bone : bones)
  {
    const fs::path folder(arguments.Output);
    if (bone.IsBone() && bone.Volume && arguments.Segments.IsRequested())
    {
      bone.Output = (folder / bone.Name / "").string();
      bone.Report = (folder / bone.Name / "report.json").string();
    }
    else if (bone.IsBone())
    {
      bone.Output = (folder / (bone.Name + "." + OutputExtension(bone, arguments))).string();
      bone.Report = (folder / (bone.Name + ".json")).string();
    }
  }
  CheckOverwriting(bones);
  return bones;
}

std::map<std::string, std::string> OptionsFor(const BatchBone& bone, const Arguments& arguments)
{
  std::map<std::string, std::string> given = arguments.Given;
  if (!bone.Volume)
  {
    for (const char* ofVolumes : { "iso", "intensities", "segments", "label-names", "format" })
    {
      given.erase(ofVolumes);
    }
  }
  if (!NeedsSpacing(bone.Input))
  {
    given.erase("spacing");
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
    const unsigned int threads = std::max(1U, std::thread::hardware_concurrency() / jobs);
    words.insert(
      words.end(), { "--" + FindOption("NumberOfThreads")->Flag, std::to_string(threads) });
  }
  words.insert(words.end(), { "--", bone.Input, bone.Output });
  return words;
}
}
