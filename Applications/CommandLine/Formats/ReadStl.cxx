// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Binary STL announces its triangles, text STL ends with a word: both tell a file that was cut
/// off. Numbers in text may have more digits than single precision.
#include "CoordinateCollector.h"
#include "FileChecks.h"
#include "FilePath.h"
#include "LineReader.h"
#include "Options/Text.h"
#include "SurfaceReaders.h"

#include "vtkCellArray.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>

namespace bonedecimate
{
namespace
{
constexpr std::uintmax_t HeaderBytes = 84;
constexpr std::uintmax_t TriangleBytes = 50; // a normal, three points and an attribute
constexpr std::size_t NormalBytes = 12;

std::uint32_t WordAt(const unsigned char* bytes)
{
  return bytes[0] | std::uint32_t(bytes[1]) << 8 | std::uint32_t(bytes[2]) << 16 |
    std::uint32_t(bytes[3]) << 24;
}

void ReadTriangles(std::ifstream& stream, std::uint32_t count, CoordinateCollector& points)
{
  std::array<unsigned char, TriangleBytes> bytes{};
  for (std::uint32_t i = 0; i < count; ++i)
  {
    stream.read(reinterpret_cast<char*>(bytes.data()), TriangleBytes);
    for (std::size_t number = 0; number < 9; ++number)
    {
      const std::uint32_t word = WordAt(&bytes[NormalBytes + 4 * number]);
      float coordinate = 0.0F;
      std::memcpy(&coordinate, &word, sizeof(coordinate));
      points.Add(coordinate);
    }
  }
}

/// What a line of text may be, in the order in which they come.
enum class Line
{
  Solid,
  Facet,
  Loop,
  Vertex,
  EndLoop,
  EndFacet,
  EndSolid,
  Other
};

Line LineOf(std::string_view word)
{
  static const std::array<const char*, 7> words = { "solid", "facet", "outer", "vertex", "endloop",
    "endfacet", "endsolid" };
  const std::string lower = LowerCase(std::string(word));
  std::size_t i = 0;
  while (i < words.size() && lower != words[i])
  {
    ++i;
  }
  return static_cast<Line>(i);
}

class TextReader
{
public:
  TextReader(const std::string& path, CoordinateCollector& points)
    : Path(path)
    , Lines(path)
    , Points(points)
  {
  }

  void Run()
  {
    while (this->Lines.Next())
    {
      const std::vector<std::string_view>& words = this->Lines.GetWords();
      const Line line = words.empty() ? Line::Other : LineOf(words[0]);
      if (line == Line::Vertex)
      {
        this->ReadVertex(words);
      }
      if (line != Line::Other)
      {
        this->Accept(line, words[0]);
      }
    }
    if (this->Before != Line::EndSolid)
    {
      Reject(this->Path, "it does not end with 'endsolid'; the file is cut off");
    }
  }

private:
  void ReadVertex(const std::vector<std::string_view>& words)
  {
    for (std::size_t i = 1; i <= 3; ++i)
    {
      const std::optional<double> coordinate =
        i < words.size() ? ParseNumber<double>(words[i]) : std::nullopt;
      if (!coordinate)
      {
        Reject(this->Path, this->Lines.Prefix() + "a vertex is not three numbers");
      }
      this->Points.Add(*coordinate);
    }
  }

  /// A triangle is three vertices between "outer loop" and "endloop", nothing else is one.
  void Accept(Line line, std::string_view word)
  {
    const Line before = this->Before;
    const bool isBetween = before == Line::Solid || before == Line::EndFacet;
    bool isInOrder = false;
    switch (line)
    {
      case Line::Solid:
        isInOrder = before == Line::EndSolid;
        break;
      case Line::Facet:
      case Line::EndSolid:
        isInOrder = isBetween;
        break;
      case Line::Vertex:
        isInOrder = (before == Line::Loop || before == Line::Vertex) && this->Vertices < 3;
        break;
      case Line::EndLoop:
        isInOrder = before == Line::Vertex && this->Vertices == 3;
        break;
      default:
        isInOrder = static_cast<int>(before) + 1 == static_cast<int>(line);
    }
    if (!isInOrder)
    {
      Reject(this->Path,
        this->Lines.Prefix() + "'" + std::string(word) +
          "' is out of place: a facet is one loop of three vertices");
    }
    this->Vertices = line == Line::Vertex ? this->Vertices + 1 : 0;
    this->Before = line;
  }

  const std::string& Path;
  LineReader Lines;
  CoordinateCollector& Points;
  Line Before = Line::EndSolid;
  int Vertices = 0; // of the loop
};

vtkSmartPointer<vtkPolyData> TrianglesOf(CoordinateCollector& collector)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(collector.MakePoints());
  vtkNew<vtkCellArray> triangles;
  const vtkIdType count = surface->GetNumberOfPoints();
  triangles->AllocateExact(count / 3, count);
  for (vtkIdType i = 0; i < count; i += 3)
  {
    triangles->InsertNextCell({ i, i + 1, i + 2 });
  }
  surface->SetPolys(triangles);
  return surface;
}
}

vtkSmartPointer<vtkPolyData> ReadStlFile(const std::string& path)
{
  const std::uintmax_t size = std::filesystem::file_size(FilePath(path));
  std::array<unsigned char, HeaderBytes> header{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(header.data()), HeaderBytes);
  const std::uint32_t count = WordAt(&header[80]);
  const std::uintmax_t expected = HeaderBytes + TriangleBytes * count;
  CoordinateCollector points;
  if (size == expected)
  {
    ReadTriangles(stream, count, points);
    return TrianglesOf(points);
  }
  const std::string begin(header.begin(), header.begin() + 5);
  if (LowerCase(begin) == "solid")
  {
    TextReader(path, points).Run();
    return TrianglesOf(points);
  }
  Reject(path,
    size < HeaderBytes ? "it is too short for an STL file"
                       : "it announces " + std::to_string(count) + " triangles (" +
        std::to_string(expected) + " bytes) but has " + std::to_string(size) + " bytes");
}
}
