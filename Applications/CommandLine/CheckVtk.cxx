// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// VTK's own formats: their readers say when data are missing, but allocate by what is announced.
#include "FileChecks.h"
#include "LineReader.h"

#include <cstdlib>
#include <filesystem>
#include <set>

namespace bonedecimate
{
namespace
{
/// Nothing compresses better than this: zlib reaches 1032, lzma not ten times as much.
constexpr double GreatestCompression = 1e4;

std::string ReadPart(const std::string& path, std::uintmax_t from, std::size_t length)
{
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(from));
  std::string text(length, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(length));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

/// The value of NAME="value" after a place in XML text; empty if it is not there.
std::string AttributeAfter(const std::string& text, std::size_t from, const std::string& name)
{
  const std::size_t begin = text.find(name + "=\"", from);
  if (begin == std::string::npos)
  {
    return {};
  }
  const std::size_t value = begin + name.size() + 2;
  return text.substr(value, text.find('"', value) - value);
}

/// Points and cells of a VTK XML file against its size.
void CheckAnnouncedXml(const std::string& path, const std::string& head, double size)
{
  const std::size_t piece = head.find("<Piece");
  for (const char* name :
    { "NumberOfPoints", "NumberOfPolys", "NumberOfStrips", "NumberOfLines", "NumberOfVerts" })
  {
    const double count = std::strtod(AttributeAfter(head, piece, name).c_str(), nullptr);
    if (piece != std::string::npos && (count < 0.0 || count > size * GreatestCompression))
    {
      Refuse(path, std::string(name) + " is more than a file of this size can hold");
    }
  }
}

const std::set<std::string_view>& LegacySections()
{
  static const std::set<std::string_view> sections = { "POINTS", "POLYGONS", "LINES", "VERTICES",
    "TRIANGLE_STRIPS", "POINT_DATA", "CELL_DATA" };
  return sections;
}
}

void CheckVtpFile(const std::string& path)
{
  const std::uintmax_t size = std::filesystem::file_size(path);
  const std::string head = ReadPart(path, 0, 65536);
  const std::size_t root = head.find("<VTKFile");
  if (root == std::string::npos)
  {
    Refuse(path, "it is not a VTK XML file");
  }
  const std::string type = AttributeAfter(head, root, "type");
  if (type != "PolyData")
  {
    Refuse(path, "it holds '" + type + "', not PolyData");
  }
  constexpr std::size_t tail = 256;
  if (ReadPart(path, size > tail ? size - tail : 0, tail).find("</VTKFile>") == std::string::npos)
  {
    Refuse(path, "it does not end with '</VTKFile>'; the file is cut off");
  }
  CheckAnnouncedXml(path, head, static_cast<double>(size));
}

void CheckVtkFile(const std::string& path)
{
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path));
  LineReader lines(path);
  if (!lines.Next() || lines.GetLine().compare(0, 14, "# vtk DataFile") != 0)
  {
    Refuse(path, "it does not begin with '# vtk DataFile'");
  }
  while (lines.Next())
  {
    const std::vector<std::string_view>& words = lines.GetWords();
    std::int64_t count = 0;
    if (words.size() == 2 && words[0] == "DATASET" && words[1] != "POLYDATA")
    {
      Refuse(path, "it holds '" + std::string(words[1]) + "', not POLYDATA");
    }
    if (words.size() >= 2 && LegacySections().count(words[0]) > 0 &&
      (!ReadInteger(words[1], count) || count < 0 || count > size))
    {
      Refuse(path,
        lines.Place() + std::string(words[0]) +
          " announces more than a file of this size can hold");
    }
  }
}
}
