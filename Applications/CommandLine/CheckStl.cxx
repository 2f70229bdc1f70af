// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Binary STL announces its triangles, text STL ends with a word: both tell a file that was cut
/// off.
#include "FileChecks.h"
#include "LineReader.h"

#include <cstdint>
#include <cstring>
#include <filesystem>

namespace bonedecimate
{
namespace
{
constexpr std::uintmax_t HeaderBytes = 84;
constexpr std::uintmax_t TriangleBytes = 50;

void CheckTextStl(const std::string& path)
{
  LineReader lines(path);
  bool inside = true; // between solid and endsolid
  while (lines.Next())
  {
    const std::vector<std::string_view>& words = lines.GetWords();
    if (words.empty())
    {
      continue;
    }
    inside = words[0] != "endsolid" && (inside || words[0] == "solid");
    for (std::size_t i = 1; words[0] == "vertex" && i <= 3; ++i)
    {
      if (i >= words.size() || !IsNumber(words[i]))
      {
        Refuse(path, lines.Place() + "a vertex is not three numbers");
      }
    }
  }
  if (inside)
  {
    Refuse(path, "it does not end with 'endsolid'; the file is cut off");
  }
}
}

void CheckStlFile(const std::string& path)
{
  const std::uintmax_t size = std::filesystem::file_size(path);
  char header[HeaderBytes] = {};
  std::ifstream(path, std::ios::binary).read(header, HeaderBytes);
  std::uint32_t count = 0;
  for (int i = 3; i >= 0; --i)
  {
    count = (count << 8) | static_cast<unsigned char>(header[80 + i]);
  }
  const std::uintmax_t expected = HeaderBytes + TriangleBytes * count;
  if (size == expected)
  {
    return;
  }
  if (std::strncmp(header, "solid", 5) == 0 || std::strncmp(header, "SOLID", 5) == 0)
  {
    CheckTextStl(path);
    return;
  }
  Refuse(path,
    size < HeaderBytes ? "it is too short for an STL file"
                       : "it announces " + std::to_string(count) + " triangles (" +
        std::to_string(expected) + " bytes) but has " + std::to_string(size) + " bytes");
}
}
