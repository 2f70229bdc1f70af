// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleFile.h"

#include <cstddef>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace
{
/// What the header of a PLY says about its two elements.
struct Layout
{
  std::size_t Points = 0;
  std::size_t Triangles = 0;
  std::size_t PointBytes = 0; ///< Size of a vertex, further properties included.
  bool IsDouble = false;
  std::size_t CountBytes = 1; ///< Size of the number before the corners of a face.
};

std::size_t BytesOf(const std::string& type)
{
  static const std::map<std::string, std::size_t> bytes = { { "char", 1 }, { "uchar", 1 },
    { "int8", 1 }, { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 },
    { "int", 4 }, { "uint", 4 }, { "int32", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 },
    { "double", 8 }, { "float64", 8 } };
  const auto found = bytes.find(type);
  if (found == bytes.end())
  {
    throw std::runtime_error("unknown PLY type " + type);
  }
  return found->second;
}

void ReadProperty(std::istringstream& words, const std::string& element, Layout& layout)
{
  std::string type;
  words >> type;
  if (element == "vertex")
  {
    layout.IsDouble = layout.IsDouble || (layout.PointBytes == 0 && BytesOf(type) == 8);
    layout.PointBytes += BytesOf(type);
  }
  else if (element == "face" && type == "list")
  {
    words >> type;
    layout.CountBytes = BytesOf(type);
  }
  else
  {
    throw std::runtime_error("a PLY with more than points and corners");
  }
}

Layout ReadHeader(std::istream& file)
{
  Layout layout;
  std::string line;
  std::string element;
  while (std::getline(file, line) && line.rfind("end_header", 0) != 0)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "format" && (words >> word) && word != "binary_little_endian")
    {
      throw std::runtime_error("a PLY that is not binary_little_endian");
    }
    if (word == "element")
    {
      words >> element >> (element == "vertex" ? layout.Points : layout.Triangles);
    }
    else if (word == "property")
    {
      ReadProperty(words, element, layout);
    }
  }
  return layout;
}

double Coordinate(const char* bytes, bool isDouble)
{
  if (isDouble)
  {
    double value = 0.0;
    std::memcpy(&value, bytes, sizeof(value));
    return value;
  }
  float value = 0.0F;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

void ReadPoints(std::istream& file, const Layout& layout, Triangles& triangles)
{
  triangles.Points.resize(layout.Points);
  std::vector<char> bytes(layout.PointBytes);
  const std::size_t step = layout.IsDouble ? 8 : 4;
  for (auto& point : triangles.Points)
  {
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      point[axis] = Coordinate(bytes.data() + axis * step, layout.IsDouble);
    }
  }
}

void ReadCorners(std::istream& file, const Layout& layout, Triangles& triangles)
{
  triangles.Corners.resize(layout.Triangles);
  const auto points = static_cast<std::int32_t>(layout.Points);
  for (auto& corners : triangles.Corners)
  {
    std::uint32_t count = 0;
    file.read(reinterpret_cast<char*>(&count), static_cast<std::streamsize>(layout.CountBytes));
    file.read(reinterpret_cast<char*>(corners.data()), sizeof(corners));
    for (const std::int32_t corner : corners)
    {
      if (count != 3 || corner < 0 || corner >= points)
      {
        throw std::runtime_error("a face that is no triangle of the file's points");
      }
    }
  }
}
}

Triangles ReadPly(const std::string& path)
{
  try
  {
    std::ifstream file(path, std::ios::binary);
    const Layout layout = ReadHeader(file);
    if (!file || layout.PointBytes < 12)
    {
      throw std::runtime_error("no PLY with points");
    }
    Triangles triangles;
    ReadPoints(file, layout, triangles);
    ReadCorners(file, layout, triangles);
    if (!file)
    {
      throw std::runtime_error("shorter than its header says");
    }
    return triangles;
  }
  catch (const std::runtime_error& failure)
  {
    throw std::runtime_error(path + ": " + failure.what());
  }
}

void WritePly(const std::string& path, const Triangles& triangles, Coordinates coordinates)
{
  std::ofstream file(path, std::ios::binary);
  const std::string type = coordinates == Coordinates::Double ? "double" : "float";
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << triangles.Points.size();
  for (const char* axis : { " x", " y", " z" })
  {
    file << "\nproperty " << type << axis;
  }
  file << "\nelement face " << triangles.Corners.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& point : triangles.Points)
  {
    const std::array<float, 3> single = { static_cast<float>(point[0]),
      static_cast<float>(point[1]), static_cast<float>(point[2]) };
    const bool isDouble = coordinates == Coordinates::Double;
    file.write(isDouble ? reinterpret_cast<const char*>(point.data())
                        : reinterpret_cast<const char*>(single.data()),
      isDouble ? sizeof(point) : sizeof(single));
  }
  for (const auto& corners : triangles.Corners)
  {
    file.put(3);
    file.write(reinterpret_cast<const char*>(corners.data()), sizeof(corners));
  }
  file.close();
  if (!file)
  {
    throw std::runtime_error(path + ": could not be written");
  }
}
