// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertifyFolders.h"

#include "BoneVolume.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "Formats/FileChecks.h"
#include "Formats/SurfaceFormat.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
/// The surfaces of a folder and below it, by their names without an extension.
std::map<std::string, std::vector<std::string>> SurfacesIn(const std::string& folder)
{
  std::map<std::string, std::vector<std::string>> found;
  try
  {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(FilePath(folder)))
    {
      const std::string file = entry.path().string();
      if (entry.is_regular_file() && FindFormat(file) != nullptr)
      {
        std::filesystem::path name = entry.path().lexically_relative(FilePath(folder));
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
}

bool AreFolders(const std::vector<std::string>& files)
{
  return files.size() == 2 && !IsVolume(files[0]) &&
    std::all_of(files.begin(), files.end(),
      [](const std::string& file) { return std::filesystem::is_directory(FilePath(file)); });
}

std::vector<FilePair> FindPairs(const std::string& references, const std::string& results)
{
  const auto ofReferences = SurfacesIn(references);
  std::vector<FilePair> pairs;
  for (const auto& [name, files] : SurfacesIn(results))
  {
    const auto reference = ofReferences.find(name);
    const std::size_t count = reference == ofReferences.end() ? 0 : reference->second.size();
    if (count != 1 || files.size() != 1)
    {
      Reject(files.front(),
        count == 0 ? "'" + references + "' has no surface of this name"
                   : "there are several surfaces of this name");
    }
    pairs.push_back({ name, reference->second.front(), files.front() });
  }
  if (pairs.empty())
  {
    Reject(results, "no surface is in it");
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
  return list.dump(2) + "\n";
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
