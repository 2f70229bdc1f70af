// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Binary STL announces its triangles, text STL ends with a word: both tell a file that was cut
/// off. Numbers in text may have more digits than single precision.
#include "CoordinateCollector.h"
#include "FileChecks.h"
#include "FileFrame.h"
#include "FilePath.h"
#include "LineReader.h"
#include "StlColors.h"
#include "StlText.h"
#include "SurfaceReaders.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>

namespace bonedecimate
{
namespace
{
constexpr std::size_t TextBytes = 80; // of the header
constexpr std::uintmax_t HeaderBytes = 84;
constexpr std::uintmax_t TriangleBytes = 50; // a normal, three points and an attribute
constexpr std::size_t NormalBytes = 12;

std::uint32_t WordAt(const unsigned char* bytes)
{
  return bytes[0] | std::uint32_t(bytes[1]) << 8 | std::uint32_t(bytes[2]) << 16 |
    std::uint32_t(bytes[3]) << 24;
}

void ReadTriangles(
  std::ifstream& stream, std::uint32_t count, CoordinateCollector& points, StlColors& colors)
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
    colors.Add(static_cast<std::uint16_t>(bytes[48] | bytes[49] << 8));
  }
}

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

/// Whether the first word is one of text STL.
bool IsText(const std::string& path)
{
  LineReader lines(path);
  while (lines.Next() && lines.GetNumber() < 100)
  {
    if (!lines.GetWords().empty())
    {
      return IsStlWord(lines.GetWords()[0]);
    }
  }
  return false;
}

[[noreturn]] void RejectBinary(
  const std::string& path, std::string_view header, std::uintmax_t size, std::uint32_t count)
{
  const bool isText = std::all_of(header.begin(), header.end(),
    [](char c) { return (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r'); });
  if (isText)
  {
    Reject(path, "it is text that does not begin with 'solid'");
  }
  if (size < HeaderBytes)
  {
    Reject(path, "it is too short for an STL file");
  }
  Reject(path,
    "it announces " + std::to_string(count) + " triangles (" +
      std::to_string(HeaderBytes + TriangleBytes * count) + " bytes) but has " +
      std::to_string(size) + " bytes");
}
}

vtkSmartPointer<vtkPolyData> ReadStlFile(
  const std::string& path, std::vector<std::string>& warnings)
{
  const std::uintmax_t size = std::filesystem::file_size(FilePath(path));
  std::array<unsigned char, HeaderBytes> header{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(header.data()), HeaderBytes);
  const std::string_view text(reinterpret_cast<const char*>(header.data()), TextBytes);
  const std::uint32_t count = WordAt(&header[TextBytes]);
  CoordinateCollector points;
  if (size == HeaderBytes + TriangleBytes * count)
  {
    StlColors colors(text);
    ReadTriangles(stream, count, points, colors);
    const vtkSmartPointer<vtkPolyData> surface = TrianglesOf(points);
    colors.AddTo(surface, warnings);
    SetFrame(FrameIn(text), surface);
    return surface;
  }
  if (!IsText(path))
  {
    RejectBinary(path, text.substr(0, std::min<std::uintmax_t>(size, TextBytes)), size, count);
  }
  const std::string frame = ReadStlText(path, points);
  const vtkSmartPointer<vtkPolyData> surface = TrianglesOf(points);
  SetFrame(frame, surface);
  return surface;
}
}
