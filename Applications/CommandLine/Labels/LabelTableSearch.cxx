// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels/LabelTableSearch.h"

#include "Base/Text.h"
#include "BoneVolume.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "FolderEntries.h"
#include "PlainText.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
using Paths = std::vector<fs::path>;

/// The name without an extension of volumes.
std::string StemOf(const fs::path& map)
{
  const std::string name = map.filename().string();
  std::string stem = map.stem().string();
  for (const std::string& extension : VolumeExtensions())
  {
    const std::string end = "." + extension;
    const bool endsSo =
      name.size() > end.size() && LowerCase(name.substr(name.size() - end.size())) == end;
    const std::string shorter = endsSo ? name.substr(0, name.size() - end.size()) : stem;
    stem = shorter.size() < stem.size() ? shorter : stem;
  }
  return stem;
}

bool IsFile(const fs::path& path)
{
  std::error_code error;
  return fs::is_regular_file(path, error);
}

Paths OfSameName(const fs::path& folder, const std::string& stem)
{
  Paths paths;
  for (const char* end : { ".tsv", ".csv", ".ctbl", "_ColorTable.ctbl", ".label", ".txt" })
  {
    const fs::path path = folder / FilePath(stem + end);
    if (IsFile(path))
    {
      paths.push_back(path);
    }
  }
  return paths;
}

/// Whether the table of BIDS, which a file inherits that has all of its words, is that of the map.
bool IsInherited(const fs::path& table, const std::string& stem)
{
  const std::vector<std::string> words = SplitAt(stem, '_');
  const std::vector<std::string> needed = SplitAt(table.stem().string(), '_');
  const bool isGeneral = needed.size() == 1;
  return LowerCase(table.extension().string()) == ".tsv" && needed.back() == "dseg" &&
    (isGeneral ||
      std::all_of(needed.begin(), needed.end(),
        [&words](const std::string& word)
        { return std::find(words.begin(), words.end(), word) != words.end(); }));
}

Paths Inherited(const fs::path& folder, const std::string& stem)
{
  Paths paths;
  std::error_code error;
  for (const fs::path& path : FolderEntries(folder, error))
  {
    if (IsInherited(path, stem) && IsFile(path))
    {
      paths.push_back(path);
    }
  }
  // The one with most words counts.
  const auto words = [](const fs::path& path) { return SplitAt(path.stem().string(), '_').size(); };
  std::size_t most = 0;
  for (const fs::path& path : paths)
  {
    most = std::max(most, words(path));
  }
  paths.erase(std::remove_if(paths.begin(), paths.end(),
                [&](const fs::path& path) { return words(path) < most; }),
    paths.end());
  return paths;
}

Paths OfDataset(const fs::path& folder)
{
  const std::string name = LowerCase(fs::absolute(folder).lexically_normal().filename().string());
  Paths paths = { folder / "dataset.json" };
  if (name.compare(0, 6, "labels") == 0)
  {
    paths.push_back(folder / ".." / "dataset.json");
  }
  paths.erase(
    std::remove_if(paths.begin(), paths.end(), [](const fs::path& path) { return !IsFile(path); }),
    paths.end());
  return paths;
}

std::string NameOf(const fs::path& path)
{
  return PlainText(path.filename().string());
}

/// The first table of the files.
FoundTable FirstOf(const Paths& paths)
{
  FoundTable first;
  for (const fs::path& path : paths)
  {
    LabelTable table = ReadLabelTable(path.string());
    if (table.IsOther)
    {
      continue; // a file of another kind that has the name
    }
    if (!table.Problem.empty())
    {
      first.Warning =
        NameOf(path) + ", beside the label map, is no table of its labels: " + table.Problem;
    }
    else if (!table.IsEmpty() && first.Path.empty())
    {
      first.Path = path.string();
      first.Table = std::move(table);
    }
    else if (const std::string contradiction = ContradictionOf(
               first.Table.Labels, BaseName(first.Path), table.Labels, NameOf(path));
             !contradiction.empty())
    {
      first = FoundTable();
      first.Warning = "two files beside the label map contradict each other, so that no names are "
                      "taken from them: " +
        contradiction + "; --label-names FILE chooses one";
      return first;
    }
  }
  return first;
}

/// In lower case, with blanks for what names write in their stead.
std::string Comparable(const std::string& name)
{
  std::string text = LowerCase(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  std::replace(text.begin(), text.end(), '-', ' ');
  return text;
}
}

bool IsGenericName(const std::string& name)
{
  const std::string text = Comparable(name);
  const std::size_t digits = text.find_last_not_of("0123456789") + 1;
  if (digits == text.size())
  {
    return text.empty();
  }
  const std::string word = text.substr(0, text.find_last_not_of(' ', digits - 1) + 1);
  const auto words = { "", "segment", "label", "region", "class", "roi" };
  return digits == 0 || std::find(words.begin(), words.end(), word) != words.end();
}

std::string ContradictionOf(const std::vector<NamedLabel>& a, const std::string& nameOfA,
  const std::vector<NamedLabel>& b, const std::string& nameOfB)
{
  std::map<std::int64_t, std::string> names;
  for (const NamedLabel& label : a)
  {
    if (!IsGenericName(label.Name))
    {
      names[label.Value] = label.Name;
    }
  }
  const auto contradicts = [&names](const NamedLabel& label)
  {
    const auto other = names.find(label.Value);
    return other != names.end() && !IsGenericName(label.Name) &&
      Comparable(other->second) != Comparable(label.Name);
  };
  const auto label = std::find_if(b.begin(), b.end(), contradicts);
  return label == b.end() ? std::string()
                          : "label " + std::to_string(label->Value) + " is '" +
      names[label->Value] + "' in " + nameOfA + " and '" + label->Name + "' in " + nameOfB;
}

FoundTable FindTableBeside(const std::string& labelMap)
{
  const fs::path map = FilePath(labelMap);
  const fs::path folder = map.parent_path().empty() ? fs::path(".") : map.parent_path();
  const std::string stem = StemOf(map);
  FoundTable found;
  if (stem.empty())
  {
    return found;
  }
  for (const Paths& paths :
    { OfSameName(folder, stem), Inherited(folder, stem), OfDataset(folder) })
  {
    if (found.Path.empty() && found.Warning.empty())
    {
      found = FirstOf(paths);
    }
  }
  return found;
}
}
