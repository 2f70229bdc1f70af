// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NrrdText.h"

#include "Base/Text.h"
#include "FilePath.h"
#include "TextNumbers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>

namespace bonedecimate::volume
{
namespace
{
namespace fs = std::filesystem;

constexpr std::uint64_t LongestHeader = std::uint64_t(1) << 28;
constexpr std::size_t MostKeys = 10000; // that the library reads in less than a second

/// Whether there are finite numbers for three axes; an axis of components has none.
bool AreOfThreeAxes(const std::string& text)
{
  const auto numbers = ParseNumbers(text);
  return numbers &&
    std::count_if(
      numbers->begin(), numbers->end(), [](double value) { return std::isfinite(value); }) >= 3;
}

/// A name that no other file has.
std::string TemporaryName()
{
  std::random_device random;
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  const std::string name = "bonedecimate-" + std::to_string(random()) + std::to_string(random());
  return (folder / FilePath(name + ".nhdr")).string();
}
}

std::string NrrdText::FieldOf(const std::string& name) const
{
  for (const std::string& field : this->Fields)
  {
    const std::size_t colon = field.find(':');
    if (colon != std::string::npos && LowerCase(Trimmed(field.substr(0, colon))) == name)
    {
      return Trimmed(field.substr(colon + 1));
    }
  }
  return std::string();
}

std::string NrrdText::DataFile() const
{
  const std::string name = this->FieldOf("data file");
  return name.empty() ? this->FieldOf("datafile") : name;
}

bool NrrdText::HasSpacing() const
{
  std::string directions = this->FieldOf("space directions");
  std::replace_if(
    directions.begin(), directions.end(), [](char c) { return c == '(' || c == ')'; }, ' ');
  for (std::size_t at = directions.find("none"); at != std::string::npos;
       at = directions.find("none"))
  {
    directions.erase(at, 4);
  }
  return AreOfThreeAxes(directions) || AreOfThreeAxes(this->FieldOf("spacings"));
}

NrrdText ReadNrrdText(const std::string& path)
{
  NrrdText text;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (text.Bytes < LongestHeader && std::getline(file, line))
  {
    text.Bytes += line.size() + (file.eof() ? 0 : 1);
    ++text.Lines;
    line.erase(line.find_last_not_of('\r') + 1);
    text.IsEnded = line.empty();
    if (line.empty() || (text.Lines == 1 && line.compare(0, 4, "NRRD") != 0))
    {
      break;
    }
    const std::size_t colon = line.find(':');
    if (line[0] != '#')
    {
      const bool isKey = colon != std::string::npos && line.compare(colon, 2, ":=") == 0;
      (isKey ? text.Keys : text.Fields).push_back(line);
    }
  }
  return text;
}

NrrdHeaderFile::NrrdHeaderFile(const std::string& path, const NrrdText& text)
  : Path(path)
{
  if (text.Keys.size() <= MostKeys)
  {
    return;
  }
  const std::string shortened = this->Compose(path, text);
  const std::string name = TemporaryName();
  std::FILE* const file = this->Problem.empty() ? std::fopen(name.c_str(), "wbx") : nullptr;
  if (!file)
  {
    this->Problem = this->Problem.empty()
      ? "its header has more than " + std::to_string(MostKeys) + " keys, which cannot be left out"
      : this->Problem;
    return;
  }
  this->Temporary = name;
  this->Path = name;
  const bool isWritten =
    std::fwrite(shortened.data(), 1, shortened.size(), file) == shortened.size();
  this->Problem = std::fclose(file) == 0 && isWritten ? "" : "its header cannot be copied";
}

NrrdHeaderFile::~NrrdHeaderFile()
{
  if (!this->Temporary.empty())
  {
    std::error_code ignored;
    fs::remove(FilePath(this->Temporary), ignored);
  }
}

/// The fields and the keys of segments; the voxels stay where they are.
std::string NrrdHeaderFile::Compose(const std::string& path, const NrrdText& text)
{
  const std::string name = text.DataFile();
  std::string shortened;
  for (const std::string& field : text.Fields)
  {
    const std::string key = LowerCase(Trimmed(field.substr(0, field.find(':'))));
    shortened += key == "data file" || key == "datafile" ? "" : field + "\n";
  }
  std::size_t count = 0;
  for (const std::string& key : text.Keys)
  {
    const bool isOfSegment = key.compare(0, 7, "Segment") == 0;
    shortened += isOfSegment ? key + "\n" : "";
    count += isOfSegment ? 1 : 0;
  }
  if (count > MostKeys)
  {
    this->Problem = "its header has more than " + std::to_string(MostKeys) + " keys of segments";
  }
  const fs::path whole = fs::absolute(FilePath(path));
  const fs::path voxels = name.empty() ? whole : whole.parent_path() / FilePath(name);
  const bool isInFile = name.empty();
  if (isInFile && (!text.FieldOf("line skip").empty() || !text.FieldOf("byte skip").empty()))
  {
    this->Problem = "its header has more than " + std::to_string(MostKeys) +
      " keys, and its voxels do not follow it";
  }
  return shortened + (isInFile ? "line skip: " + std::to_string(text.Lines) + "\n" : "") +
    "data file: " + voxels.string() + "\n\n";
}
}
