// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HeaderText.h
 * @brief The text in front of the voxels of MetaImage and NRRD files: lines of a key and a value.
 */
#ifndef BoneDecimate_Applications_HeaderText_h
#define BoneDecimate_Applications_HeaderText_h

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// One way to write a header.
struct HeaderSyntax
{
  std::string
    Magic; ///< How the first line begins, which is no field; empty: the first line is a field.
  char Separator; ///< Between key and value.
  std::string
    LastBucket; ///< After its line the voxels begin; empty: after an empty line, or nowhere.
};

struct HeaderText
{
  std::map<std::string, std::string> Fields; ///< Keys in lower case.
  std::set<std::string>
    PairKeys;           ///< Of pairs key:=value, in lower case; their values are not kept.
  std::int64_t End = 0; ///< Bytes before the voxels, if they are in this file.
  std::string Problem;  ///< Why it could not be read; empty if it was.

  /// The value of the first of these keys that is there; empty if none is.
  std::string Value(const std::vector<std::string>& keys) const;
};

HeaderText ReadHeaderText(const std::string& path, const HeaderSyntax& syntax);

/// Without blanks, line ends and zeros at either end.
std::string Trimmed(const std::string& text);

/// Numbers between blanks, commas, backslashes or brackets; none if anything else is there.
std::optional<std::vector<double>> ParseNumbers(const std::string& text);

/// The same, for whole numbers.
std::optional<std::vector<std::int64_t>> ParseWholeNumbers(const std::string& text);

/// Where the voxels lie if not in the header's file: the name is taken from the header's folder.
std::string BesideHeader(const std::string& headerPath, const std::string& dataFile);
}

#endif
