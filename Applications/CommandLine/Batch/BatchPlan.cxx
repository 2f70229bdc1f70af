// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchPlan.h"

#include "Base/Text.h"
#include "BoneVolume.h"
#include "ExitCode.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "FolderEntries.h"
#include "Formats/FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "NamePattern.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
bool TakesVolumes(const Arguments& arguments)
{
  return arguments.Iso || arguments.Segments.IsRequested();
}

/// A file of a folder that was searched, or a folder with a volume, with the reason if it is no
/// bone.
BatchBone BoneOf(const fs::path& path, bool takesVolumes)
{
  BatchBone bone;
  bone.Input = path.string();
  bone.Volume = IsVolume(bone.Input);
  if (bone.Volume && !takesVolumes)
  {
    bone.WhyNot = "a volume: --iso HU or, of a label map, --segments says which surface to take";
    bone.CodeIfNot = ExitCode::LeftOut;
  }
  else if (!bone.Volume && FindFormat(bone.Input) == nullptr)
  {
    const std::string extension = path.extension().string();
    bone.WhyNot = "not a surface or volume: " + (extension.empty() ? "no extension" : extension);
  }
  return bone;
}

/// Whether a batch wrote its table there.
bool HasResultsOfBatch(const fs::path& folder)
{
  std::ifstream table(folder / "summary.csv");
  std::string heading;
  return std::getline(table, heading) && heading.rfind("name,input,output,", 0) == 0;
}

/// Finds the bones of a folder and of the folders in it.
class FolderSearch
{
public:
  FolderSearch(std::vector<BatchBone>& bones, const fs::path& root, const Arguments& arguments)
    : Bones(bones)
    , Root(root)
    , Requested(arguments)
  {
  }

  /// @returns What is wrong with the folder; empty if nothing is.
  std::string Search(const fs::path& folder)
  {
    std::error_code error;
    for (const fs::path& path : FolderEntries(folder, error))
    {
      std::error_code ignored;
      const bool isHidden = path.filename().string()[0] == '.';
      if (!isHidden && !fs::equivalent(path, FilePath(this->Requested.Output), ignored))
      {
        this->Take(path);
      }
    }
    return error ? error.message() : std::string();
  }

private:
  void Take(const fs::path& path)
  {
    std::error_code error;
    const bool isFolder = fs::is_directory(path, error);
    if (isFolder && !IsVolume(path.string()))
    {
      this->TakeFolder(path);
    }
    else if (this->IsRequested(path))
    {
      this->Add(BoneOf(path, TakesVolumes(this->Requested)));
    }
  }

  void TakeFolder(const fs::path& path)
  {
    std::error_code error;
    BatchBone problem;
    problem.Input = path.string();
    if (fs::is_symlink(path, error))
    {
      problem.WhyNot = "a link to a folder, which is not followed";
    }
    else if (HasResultsOfBatch(path))
    {
      problem.WhyNot = "results of a batch: they are inputs only if this folder is named itself";
    }
    else if (const std::string message = this->Search(path); !message.empty())
    {
      problem.WhyNot = "could not be searched: " + message;
      problem.CodeIfNot = ExitCode::InputRejected;
    }
    if (!problem.IsBone())
    {
      this->Add(problem);
    }
  }

  void Add(BatchBone bone)
  {
    bone.Root = this->Root.string();
    bone.Below = FilePath(bone.Input).lexically_relative(this->Root).parent_path().string();
    this->Bones.push_back(bone);
  }

  /// By the pattern of --only, of the name or of the path below the folder that was named.
  bool IsRequested(const fs::path& path) const
  {
    const std::string& pattern = this->Requested.Only;
    return pattern.empty() || MatchesPattern(path.filename().string(), pattern) ||
      MatchesPattern(path.lexically_relative(this->Root).generic_string(), pattern);
  }

  std::vector<BatchBone>& Bones;
  const fs::path& Root;
  const Arguments& Requested;
};

/// The last part of a path, with or without a slash behind it.
fs::path WithoutSlash(const std::string& name)
{
  const fs::path path = FilePath(name);
  return path.has_filename() ? path : path.parent_path();
}

void AddFolder(std::vector<BatchBone>& bones, const std::string& folder, const Arguments& arguments)
{
  const fs::path root = WithoutSlash(folder);
  const std::string problem = FolderSearch(bones, root, arguments).Search(root);
  if (!problem.empty())
  {
    throw Failure(ExitCode::InputRejected, "'" + folder + "' was rejected: " + problem);
  }
}

void AddFileOrFolder(std::vector<BatchBone>& bones, const std::string& input)
{
  BatchBone bone;
  bone.Input = input;
  bone.Root = fs::absolute(WithoutSlash(input)).parent_path().string();
  bone.Volume = IsVolume(input);
  bones.push_back(bone);
}

/// How much of an input's path goes into its name, from little to all that is there.
std::string NameOf(const BatchBone& bone, int detail)
{
  const fs::path file = WithoutSlash(bone.Input);
  std::error_code error;
  std::string name = file.filename().string();
  // The name of a folder may have dots, but its output must not be named like a file.
  if (!fs::is_directory(file, error) || IsNamedLikeFile(name))
  {
    const bool isCompressed = ExtensionOf(name) == "gz"; // "ct.nii.gz" is "ct"
    const fs::path plain = isCompressed ? file.stem() : file.filename();
    name = plain.stem().string() + (detail > 0 ? "_" + ExtensionOf(plain.string()) : "");
  }
  name = detail > 1 ? WithoutSlash(bone.Root).filename().string() + "_" + name : name;
  return (FilePath(bone.Below) / FilePath(name)).generic_string(); // as in the table
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
        bone->Name = NameOf(*bone, detail);
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
      one.Name = PathBelow(one);
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
    const bool areVolumes = std::any_of(bones.begin(), bones.end(),
      [](const BatchBone& bone) { return bone.CodeIfNot == ExitCode::LeftOut; });
    const std::string kinds = areVolumes ? "no surface file" : "no surface or volume";
    Reject(arguments.Inputs[0],
      kinds +
        (arguments.Only.empty()
            ? " is in it"
            : " in it has a name, or path below the folder, that matches --only '" +
              arguments.Only + "'") +
        (areVolumes ? "; volumes need --iso HU or --segments" : ""));
  }
  const auto isVolume = [](const BatchBone& bone) { return bone.Volume; };
  if (arguments.Iso && std::none_of(bones.begin(), bones.end(), isVolume))
  {
    throw Failure(ExitCode::Usage,
      "--iso is for volumes; none of the inputs is one: read are " + ReadVolumesText());
  }
  if (arguments.Segments.IsRequested() && std::none_of(bones.begin(), bones.end(), isVolume))
  {
    throw Failure(ExitCode::Usage,
      "--segments is for label maps; none of the inputs is one: read are " + ReadVolumesText());
  }
}

void CheckOverwriting(const std::vector<BatchBone>& bones)
{
  const auto canonical = [](const std::string& path)
  {
    std::error_code error;
    return fs::weakly_canonical(WithoutSlash(path), error).string();
  };
  std::set<std::string> inputs;
  for (const BatchBone& bone : bones)
  {
    inputs.insert(canonical(bone.Input));
  }
  for (const BatchBone& bone : bones)
  {
    if (bone.IsBone() && inputs.count(canonical(bone.Output)) > 0)
    {
      throw Failure(ExitCode::Usage, "'" + bone.Output + "' is an input; it is not overwritten");
    }
  }
}

void NameOutputs(BatchBone& bone, const Arguments& arguments)
{
  const fs::path folder = FilePath(arguments.Output);
  const fs::path name = FilePath(bone.Name);
  if (bone.IsBone() && bone.Volume && arguments.Segments.IsRequested())
  {
    bone.Output = (folder / name / "").string();
    bone.Report = (folder / name / "report.json").string();
  }
  else if (bone.IsBone())
  {
    bone.Output = (folder / name).string() + "." + OutputExtension(bone, arguments);
    bone.Report = (folder / name).string() + ".json";
  }
}
}

std::string PathBelow(const BatchBone& bone)
{
  return (FilePath(bone.Below) / FilePath(BaseName(bone.Input))).generic_string();
}

std::vector<BatchBone> FindBones(const Arguments& arguments)
{
  std::vector<BatchBone> bones;
  for (const std::string& input : arguments.Inputs)
  {
    std::error_code error;
    if (fs::is_directory(FilePath(input), error) && !IsVolume(input))
    {
      AddFolder(bones, input, arguments);
    }
    else
    {
      AddFileOrFolder(bones, input);
    }
  }
  NameAll(bones);
  return bones;
}

std::vector<BatchBone> PlanBatch(const Arguments& arguments)
{
  std::vector<BatchBone> bones = FindBones(arguments);
  CheckThatThereAreBones(bones, arguments);
  for (BatchBone& bone : bones)
  {
    NameOutputs(bone, arguments);
  }
  CheckOverwriting(bones);
  return bones;
}
}
