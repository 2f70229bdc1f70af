// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// VTK's XML format: its reader says when data are missing, but allocates by what is announced.
#include "Base/Text.h"
#include "CoordinateCollector.h"
#include "FileChecks.h"
#include "FilePath.h"
#include "LineReader.h"
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

/// The value of an attribute of the tag that begins at a position, in either kind of quotes; empty
/// if it is not there.
std::string AttributeOf(const std::string& text, std::size_t tag, std::string_view name)
{
  const char* const blanks = " \t\r\n";
  const auto skip = [&text, blanks](std::size_t at)
  { return std::min(text.find_first_not_of(blanks, at), text.size()); };
  const auto isAt = [&text](std::size_t at, std::string_view characters)
  { return at < text.size() && characters.find(text[at]) != std::string_view::npos; };
  for (std::size_t at = tag; at < text.size() && text[at] != '>'; ++at)
  {
    if (isAt(at, "\"'"))
    {
      at = std::min(text.find(text[at], at + 1), text.size() - 1); // a value
      continue;
    }
    const bool isName =
      at > tag && isAt(at - 1, blanks) && text.compare(at, name.size(), name) == 0;
    const std::size_t equals = isName ? skip(at + name.size()) : text.size();
    const std::size_t quote = isAt(equals, "=") ? skip(equals + 1) : text.size();
    if (isAt(quote, "\"'"))
    {
      return text.substr(quote + 1, text.find(text[quote], quote + 1) - quote - 1);
    }
  }
  return {};
}

/// Points and cells of a VTK XML file against its size.
void CheckAnnouncedXml(const std::string& path, const std::string& head, double size)
{
  const std::size_t piece = head.find("<Piece");
  const std::string compressor = AttributeOf(head, head.find("<VTKFile"), "compressor");
  const double most = size * LargestExpansion(compressor); // a point or cell has a byte or more
  for (const char* name :
    { "NumberOfPoints", "NumberOfPolys", "NumberOfStrips", "NumberOfLines", "NumberOfVerts" })
  {
    const double count = std::strtod(AttributeOf(head, piece, name).c_str(), nullptr);
    if (piece != std::string::npos && (count < 0.0 || count > most))
    {
      Reject(path, std::string(name) + " is more than a file of this size can hold");
    }
  }
}

/// Reads the points of every piece; stops at a piece that has its points in binary.
void ReadTextPoints(const std::string& path, std::uintmax_t size, CoordinateCollector& points)
{
  const std::string text = ReadPart(path, 0, static_cast<std::size_t>(size));
  for (std::size_t at = text.find("<Points"); at != std::string::npos;
       at = text.find("<Points", at + 1))
  {
    const std::size_t array = text.find("<DataArray", at);
    const std::size_t begin = std::min(text.find('>', array), text.size());
    const std::string tag = array < begin ? text.substr(array, begin - array) : std::string();
    if (AttributeOf(tag, 0, "format") != "ascii")
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
  const std::string type = AttributeOf(head, root, "type");
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
  if (AttributeOf(head, head.find("<DataArray", head.find("<Points")), "format") == "ascii")
  {
    ReadTextPoints(path, size, textPoints);
  }
}
}
