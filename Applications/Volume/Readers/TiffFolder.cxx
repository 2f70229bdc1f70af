// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TiffFolder.h"

#include "Base/Text.h"
#include "FilePath.h"
#include "FolderEntries.h"
#include "TextNumbers.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace bonedecimate::volume
{
namespace
{
namespace fs = std::filesystem;

/// Reads numbers of a TIFF file in its byte order; 0 beyond its end.
class TiffNumbers
{
public:
  explicit TiffNumbers(const std::string& path)
    : File(path, std::ios::binary)
  {
    char order = 0;
    this->File.get(order);
    this->IsBigEndian = order == 'M';
  }

  std::uint64_t At(std::uint64_t position, int bytes)
  {
    std::uint64_t number = 0;
    this->File.clear();
    this->File.seekg(static_cast<std::streamoff>(position));
    for (int i = 0; i < bytes; ++i)
    {
      const int byte = this->File.get();
      this->IsTruncated = this->IsTruncated || byte < 0;
      const auto part = static_cast<std::uint64_t>(byte < 0 ? 0 : byte);
      number = this->IsBigEndian ? number << 8 | part : number | part << 8 * i;
    }
    return number;
  }

  bool IsTiff() { return this->IsBig() || this->At(2, 2) == 42; }

  /// A directory is a count, its entries, and the position of the next directory.
  std::uint64_t FirstDirectory() { return this->IsBig() ? this->At(8, 8) : this->At(4, 4); }

  /// 0: there is none.
  std::uint64_t NextDirectory(std::uint64_t directory)
  {
    const bool isBig = this->IsBig();
    const std::uint64_t entries = this->At(directory, isBig ? 8 : 2);
    return this->At(directory + (isBig ? 8 + 20 * entries : 2 + 12 * entries), isBig ? 8 : 4);
  }

  bool IsTruncated = false; ///< A number was beyond the end.

private:
  bool IsBig() { return this->At(2, 2) == 43; }

  std::ifstream File;
  bool IsBigEndian = false;
};

std::vector<fs::path> VisibleFiles(const std::string& folder)
{
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::path& path : FolderEntries(FilePath(folder), error))
  {
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored) && path.filename().string()[0] != '.')
    {
      files.push_back(path);
    }
  }
  return files;
}

std::vector<fs::path> TiffFiles(const std::string& folder)
{
  std::vector<fs::path> files = VisibleFiles(folder);
  files.erase(std::remove_if(files.begin(), files.end(),
                [](const fs::path& file) { return !IsNamedLikeTiff(file.string()); }),
    files.end());
  return files;
}

/// How many characters all names have in common at their beginning, but for digits at its end: they
/// are of the number that follows.
std::size_t CommonBeginning(const std::vector<std::string>& names)
{
  std::size_t common = names.front().size();
  for (const std::string& name : names)
  {
    const auto end = std::mismatch(name.begin(),
      name.begin() + static_cast<std::ptrdiff_t>(std::min(common, name.size())),
      names.front().begin());
    common = static_cast<std::size_t>(end.first - name.begin());
  }
  while (common > 0 && std::isdigit(static_cast<unsigned char>(names.front()[common - 1])) != 0)
  {
    --common;
  }
  return common;
}

/// What differs between the names, as numbers; nothing where it is none.
std::vector<std::optional<std::int64_t>> NumbersOf(std::vector<std::string> names)
{
  const std::size_t beginning = CommonBeginning(names);
  for (std::string& name : names)
  {
    name.erase(0, beginning);
    std::reverse(name.begin(), name.end());
  }
  const std::size_t end = CommonBeginning(names);
  std::vector<std::optional<std::int64_t>> numbers;
  for (std::string& name : names)
  {
    name.erase(0, end);
    std::reverse(name.begin(), name.end());
    numbers.push_back(ParseWholeNumber(name));
  }
  return numbers;
}
}

bool IsNamedLikeTiff(const std::string& path)
{
  const std::string extension = LowerCase(FilePath(path).extension().string());
  return extension == ".tif" || extension == ".tiff";
}

bool IsTiffPicture(const std::string& path)
{
  TiffNumbers numbers(path);
  return numbers.IsTiff() && numbers.NextDirectory(numbers.FirstDirectory()) == 0 &&
    !numbers.IsTruncated;
}

bool HasCircularPages(const std::string& path)
{
  TiffNumbers numbers(path);
  std::set<std::uint64_t> known;
  std::uint64_t directory = numbers.IsTiff() ? numbers.FirstDirectory() : 0;
  while (directory != 0 && !numbers.IsTruncated && known.insert(directory).second)
  {
    directory = numbers.NextDirectory(directory);
  }
  return directory != 0 && !numbers.IsTruncated;
}

bool HoldsTiffSlices(const std::string& folder)
{
  const std::vector<fs::path> files = TiffFiles(folder);
  return files.size() >= 2 && 2 * files.size() > VisibleFiles(folder).size() &&
    IsTiffPicture(files.front().string());
}

TiffSlices FindTiffSlices(const std::string& folder)
{
  const std::vector<fs::path> files = TiffFiles(folder);
  std::vector<std::string> names(files.size());
  std::transform(files.begin(), files.end(), names.begin(),
    [](const fs::path& file) { return file.filename().string(); });
  const auto numbers = NumbersOf(names);
  std::vector<std::pair<std::int64_t, std::string>> ordered;
  TiffSlices slices;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    if (!numbers[i])
    {
      slices.Problem = "the order of its slices is not known, because the name " + names[i] +
        " differs from the others by more than a number";
      return slices;
    }
    ordered.emplace_back(*numbers[i], files[i].string());
  }
  std::sort(ordered.begin(), ordered.end());
  for (std::size_t i = 0; i < ordered.size(); ++i)
  {
    slices.Files.push_back(ordered[i].second);
    const bool isNext =
      i < 2 || ordered[i].first - ordered[i - 1].first == ordered[1].first - ordered[0].first;
    if (!isNext || (i > 0 && ordered[i].first == ordered[i - 1].first))
    {
      slices.Problem = "the numbers in the names of its slices are not evenly spaced: one before " +
        FilePath(ordered[i].second).filename().string() + " is missing or there twice";
    }
  }
  return slices;
}
}
