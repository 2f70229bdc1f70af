// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NrrdText.h
 * @brief The lines of a NRRD header, before its library reads them: what it would wait for without
 * end or take too long for.
 */
#ifndef BoneDecimate_Applications_NrrdText_h
#define BoneDecimate_Applications_NrrdText_h

#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
struct NrrdText
{
  std::vector<std::string> Fields; ///< "NAME: TEXT", and the first line; without comments.
  std::vector<std::string> Keys;   ///< "KEY:=VALUE"
  std::uint64_t Bytes = 0;         ///< With the empty line at the end, if there is one.
  std::int64_t Lines = 0;          ///< With this line.
  bool IsEnded = false;            ///< By this line.

  /// Value of the field, whose name is in lower case; empty if there is no such field.
  std::string FieldOf(const std::string& name) const;

  /// The name of the file of the voxels; empty if they are in the file itself.
  std::string DataFile() const;

  /// Whether it says how far voxels are apart.
  bool HasSpacing() const;
};

NrrdText ReadNrrdText(const std::string& path);

/**
 * A header that the library reads in a time that grows with its size: it compares each key with all
 * before it. Where there are many, this is a file of its own with the keys that describe segments,
 * which is removed at the end.
 */
class NrrdHeaderFile
{
public:
  NrrdHeaderFile(const std::string& path, const NrrdText& text);
  ~NrrdHeaderFile();
  NrrdHeaderFile(const NrrdHeaderFile&) = delete;
  NrrdHeaderFile& operator=(const NrrdHeaderFile&) = delete;

  /// Path of the file to give to the library.
  const std::string& GetPath() const { return this->Path; }
  bool IsShortened() const { return !this->Temporary.empty(); }

  /// Why there is no such file; empty if there is one.
  const std::string& GetProblem() const { return this->Problem; }

private:
  std::string Compose(const std::string& path, const NrrdText& text);

  std::string Path;
  std::string Temporary;
  std::string Problem;
};
}

#endif
