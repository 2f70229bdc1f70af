// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// VTK's XML format: its reader says when data are missing, but allocates by what is announced.
#include "CoordinateCollector.h"
#include "FileChecks.h"
#include "FilePath.h"
#include "LineReader.h"
#include "Options/Text.h"
#include "XmlNesting.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace bonedecimate
{
namespace
{
/// How many bytes of data one byte of a file can represent at most.
double LargestExpansion(const std::string& compressor)
{
  constexpr double zlib = 1032.0;
  constexpr double lz4 = 255.0;
  constexpr double lzma = 1e4;
  return compressor.empty()                        ? 1.0
    : compressor.find("ZLib") != std::string::npos ? zlib
    : compressor.find("LZ4") != std::string::npos  ? lz4
                                                   : lzma;
}

std::string ReadPart(const std::string& path, std::uintmax_t from, std::size_t length)
{
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(from));
  std::string text(length, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(length));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

/// The value of NAME="value" after a position in XML text; empty if it is not there.
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
  const std::string compressor = AttributeAfter(head, head.find("<VTKFile"), "compressor");
  const double most = size * LargestExpansion(compressor); // a point or cell has a byte or more
  for (const char* name :
    { "NumberOfPoints", "NumberOfPolys", "NumberOfStrips", "NumberOfLines", "NumberOfVerts" })
  {
    const double count = std::strtod(AttributeAfter(head, piece, name).c_str(), nullptr);
    if (piece != std::string::npos && (count < 0.0 || count > most))
    {
      Reject(path, std::string(name) + " is more than a file of this size can hold");
    }
  }
}

/// Of every piece; nothing where a piece has its points in binary.
void ReadTextPoints(const std::string& path, std::uintmax_t size, CoordinateCollector& points)
{
  const std::string text = ReadPart(path, 0, static_cast<std::size_t>(size));
  for (std::size_t at = text.find("<Points"); at != std::string::npos;
       at = text.find("<Points", at + 1))
  {
    const std::size_t array = text.find("<DataArray", at);
    const std::size_t begin = std::min(text.find('>', array), text.size());
    const std::string tag = array < begin ? text.substr(array, begin - array) : std::string();
    if (AttributeAfter(tag, 0, "format") != "ascii")
    {
      return;
    }
    const std::string_view numbers =
      std::string_view(text).substr(begin, text.find('<', begin) - begin);
    std::vector<std::string_view> words;
    SplitWords(numbers.substr(std::min<std::size_t>(1, numbers.size())), words);
    for (const std::string_view word : words)
    {
      if (const std::optional<double> number = ParseNumber<double>(word))
      {
        points.Add(*number);
      }
    }
  }
}
}

void CheckVtpFile(const std::string& path, CoordinateCollector& textPoints)
{
  const std::uintmax_t size = std::filesystem::file_size(FilePath(path));
  const std::string head = ReadPart(path, 0, 65536);
  const std::size_t root = head.find("<VTKFile");
  if (root == std::string::npos)
  {
    Reject(path, "it is not a VTK XML file");
  }
  const std::string type = AttributeAfter(head, root, "type");
  if (type != "PolyData")
  {
    Reject(path, "it holds '" + type + "', not PolyData");
  }
  constexpr std::size_t tail = 256;
  if (ReadPart(path, size > tail ? size - tail : 0, tail).find("</VTKFile>") == std::string::npos)
  {
    Reject(path, "it does not end with '</VTKFile>'; the file is cut off");
  }
  CheckNesting(path);
  CheckAnnouncedXml(path, head, static_cast<double>(size));
  // Points come first in a piece: a file whose first ones are binary is read by VTK alone.
  if (AttributeAfter(head, head.find("<Points"), "format") == "ascii")
  {
    ReadTextPoints(path, size, textPoints);
  }
}
}
