// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Wavefront OBJ has no counts to compare with, so every number and every index is looked at.
#include "FileChecks.h"
#include "LineReader.h"

#include <algorithm>
#include <array>

namespace bonedecimate
{
namespace
{
/// Points, texture coordinates and normals, in the order in which a corner "v/vt/vn" names them.
constexpr std::size_t NumberOfKinds = 3;
const std::array<const char*, NumberOfKinds> KindNames = { "vertex", "texture coordinate",
  "normal" };

class ObjCheck
{
public:
  explicit ObjCheck(const std::string& path)
    : Path(path)
    , Lines(path)
  {
  }

  void Run(std::vector<std::string>& warnings)
  {
    while (this->Lines.Next())
    {
      this->CheckLine();
    }
    for (std::size_t kind = 0; kind < NumberOfKinds; ++kind)
    {
      if (this->Largest[kind] > this->Count[kind])
      {
        Refuse(this->Path,
          std::string("a face names ") + KindNames[kind] + " " +
            std::to_string(this->Largest[kind]) + ", there are " +
            std::to_string(this->Count[kind]) + "; the file may be cut off");
      }
    }
    if (!this->Lines.IsEnded())
    {
      warnings.push_back("the last line of the input has no end; the file may be cut off");
    }
  }

private:
  [[noreturn]] void RefuseLine(const std::string& reason)
  {
    Refuse(this->Path, this->Lines.Place() + reason);
  }

  void CheckLine()
  {
    const std::vector<std::string_view>& words = this->Lines.GetWords();
    if (words.empty())
    {
      return;
    }
    if (words[0] == "v" || words[0] == "vn")
    {
      this->CheckNumbers(words, 3);
      ++this->Count[words[0] == "v" ? 0 : 2];
    }
    else if (words[0] == "vt")
    {
      this->CheckNumbers(words, 1);
      ++this->Count[1];
    }
    else if (words[0] == "f" || words[0] == "l" || words[0] == "p")
    {
      this->CheckCorners(words, words[0] == "f" ? 3 : 1);
    }
  }

  void CheckNumbers(const std::vector<std::string_view>& words, std::size_t least)
  {
    if (words.size() <= least)
    {
      this->RefuseLine("fewer than " + std::to_string(least) + " numbers; the file may be cut off");
    }
    // VTK's reader passes over a nan and takes the next vertex for this one.
    for (std::size_t i = 1; i <= least; ++i)
    {
      if (!IsFiniteNumber(words[i]))
      {
        this->RefuseLine("'" + std::string(words[i].substr(0, 40)) + "' is not a finite number");
      }
    }
  }

  void CheckCorners(const std::vector<std::string_view>& words, std::size_t least)
  {
    // A backslash carries a face on to the next line; its corners there are VTK's to read.
    const bool goesOn = words.back() == "\\";
    if (words.size() <= least && !goesOn)
    {
      this->RefuseLine("a face of fewer than 3 corners; the file may be cut off");
    }
    for (std::size_t i = 1; i + (goesOn ? 1 : 0) < words.size(); ++i)
    {
      this->CheckCorner(words[i]);
    }
  }

  void CheckCorner(std::string_view corner)
  {
    std::string_view rest = corner;
    for (std::size_t kind = 0; kind < NumberOfKinds && !rest.empty(); ++kind)
    {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      const std::string_view digits = rest.substr(0, slash);
      rest.remove_prefix(std::min(slash + 1, rest.size()));
      std::int64_t index = 0;
      if (digits.empty() && kind == 1)
      {
        continue; // "3//7" has no texture coordinate
      }
      if (!ReadInteger(digits, index) || index == 0)
      {
        this->RefuseLine("'" + std::string(corner.substr(0, 40)) + "' is not a corner of a face");
      }
      this->CheckIndex(index, kind);
    }
  }

  void CheckIndex(std::int64_t index, std::size_t kind)
  {
    if (index < -this->Count[kind])
    {
      this->RefuseLine(
        "index " + std::to_string(index) + " reaches before the first " + KindNames[kind]);
    }
    this->Largest[kind] = std::max(this->Largest[kind], index);
  }

  const std::string& Path;
  LineReader Lines;
  std::array<std::int64_t, NumberOfKinds> Count{};
  std::array<std::int64_t, NumberOfKinds> Largest{};
};
}

void CheckObjFile(const std::string& path, std::vector<std::string>& warnings)
{
  ObjCheck(path).Run(warnings);
}
}
