// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertifyFolders.h"

#include "Batch/BatchPlan.h"
#include "BoneVolume.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "Formats/FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "Report/JsonReport.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
/// Whether a part of a path begins with a dot: a batch leaves such files and folders out.
bool IsHidden(const std::filesystem::path& below)
{
  return std::any_of(below.begin(), below.end(),
    [](const std::filesystem::path& part) { return part.string().rfind('.', 0) == 0; });
}

/// The surfaces of a folder and below it, by their names without an extension.
std::map<std::string, std::vector<std::string>> SurfacesIn(const std::string& folder)
{
  std::map<std::string, std::vector<std::string>> found;
  try
  {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(FilePath(folder)))
    {
      const std::string file = entry.path().string();
      std::filesystem::path name = entry.path().lexically_relative(FilePath(folder));
      if (entry.is_regular_file() && FindFormat(file) != nullptr && !IsHidden(name))
      {
        found[name.replace_extension().generic_string()].push_back(file);
      }
    }
  }
  catch (const std::filesystem::filesystem_error& problem)
  {
    Reject(folder, problem.code().message());
  }
  return found;
}

/// What a batch would take from a folder, by the names of its results: surfaces, and volumes if
/// there is a value for their surface.
std::map<std::string, std::string> ReferencesIn(
  const std::string& folder, const std::string& results, const std::optional<double>& iso)
{
  Arguments batch;
  batch.Inputs = { folder };
  batch.Output = results; // not searched if it is below
  batch.Iso = iso;
  std::map<std::string, std::string> found;
  for (const BatchBone& bone : FindBones(batch))
  {
    if (bone.IsBone())
    {
      found[bone.Name] = bone.Input;
    }
  }
  if (found.empty())
  {
    Reject(folder,
      iso
        ? "no surface or volume is in it"
        : "no surface is in it; --iso takes the bone surface of CT volumes, and --labels compares "
          "a single result with a label map");
  }
  return found;
}
}

bool AreFolders(const std::vector<std::string>& files)
{
  return files.size() == 2 && !IsVolume(files[0]) &&
    std::all_of(files.begin(), files.end(),
      [](const std::string& file) { return std::filesystem::is_directory(FilePath(file)); });
}

std::vector<FilePair> FindPairs(
  const std::string& references, const std::string& results, const std::optional<double>& iso)
{
  const auto ofReferences = ReferencesIn(references, results, iso);
  const auto ofResults = SurfacesIn(results);
  if (ofResults.empty())
  {
    Reject(results, "no surface is in it");
  }
  const std::string noResult = "'" + results + "' has no surface of this name";
  const std::string noReference =
    "'" + references + "' has no " + (iso ? "volume or surface" : "surface") + " of this name";
  std::map<std::string, FilePair> pairs;
  for (const auto& [name, file] : ofReferences)
  {
    pairs[name] = { name, file, "", noResult };
  }
  for (const auto& [name, files] : ofResults)
  {
    FilePair& pair = pairs[name];
    pair.Name = name;
    pair.Result = files.front();
    pair.Problem = pair.Reference.empty() ? noReference
      : files.size() > 1                  ? "'" + results + "' has several surfaces of this name"
                                          : "";
  }
  std::vector<FilePair> list;
  list.reserve(pairs.size());
  for (const auto& [name, pair] : pairs)
  {
    list.push_back(pair);
  }
  return list;
}

std::vector<FilePair> PairsWithFirst(const std::vector<std::string>& files)
{
  std::vector<FilePair> pairs;
  pairs.reserve(files.size());
  for (std::size_t i = 1; i < files.size(); ++i)
  {
    pairs.push_back({ files[i], files[0], files[i], "" });
  }
  return pairs;
}

std::string JsonOfPairs(const std::vector<CertifiedPair>& pairs)
{
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const CertifiedPair& pair : pairs)
  {
    Json row = { { "name", pair.Name }, { "exit_code", static_cast<int>(pair.Code) } };
    if (pair.Json.empty())
    {
      row["problem"] = pair.Text;
    }
    else
    {
      row["certificate"] = Json::parse(pair.Json);
    }
    list.push_back(row);
  }
  return JsonText(list);
}

std::string CountsOfPairs(const std::vector<CertifiedPair>& pairs, bool hasTolerance)
{
  const auto count = [&pairs](auto belongs)
  { return std::count_if(pairs.begin(), pairs.end(), belongs); };
  const auto of = [&count](ExitCode code)
  {
    return count(
      [code](const CertifiedPair& pair) { return !pair.Json.empty() && pair.Code == code; });
  };
  std::string text = std::to_string(pairs.size()) + (pairs.size() == 1 ? " pair" : " pairs");
  std::string separator = ": ";
  for (const auto& [number, word] :
    { std::pair(of(ExitCode::Done), hasTolerance ? "proved" : "compared"),
      std::pair(of(ExitCode::Violated), "violated"),
      std::pair(of(ExitCode::Undecided), "undecided"),
      std::pair(of(ExitCode::Interrupted), "stopped"),
      std::pair(
        count([](const CertifiedPair& pair) { return pair.Json.empty(); }), "not compared") })
  {
    if (number > 0)
    {
      text += separator + std::to_string(number) + " " + word;
      separator = ", ";
    }
  }
  return text;
}

ExitCode WorstOfPairs(const std::vector<CertifiedPair>& pairs)
{
  for (const ExitCode code : { ExitCode::Interrupted, ExitCode::Violated, ExitCode::Undecided })
  {
    if (std::any_of(pairs.begin(), pairs.end(),
          [code](const CertifiedPair& pair) { return pair.Code == code; }))
    {
      return code;
    }
  }
  const auto failed = std::find_if(pairs.begin(), pairs.end(),
    [](const CertifiedPair& pair) { return pair.Code != ExitCode::Done; });
  return failed == pairs.end() ? ExitCode::Done : failed->Code;
}
}
