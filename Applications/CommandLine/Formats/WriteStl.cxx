// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WriteStl.h"

#include "ExitCode.h"
#include "FileFrame.h"
#include "TextOutput.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkTriangle.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace bonedecimate
{
namespace
{
constexpr std::size_t BytesOfHeader = 80;
constexpr std::size_t BytesOfNumber = 4;
/// Normal and three corners, and two bytes that have no meaning here.
constexpr std::size_t BytesOfTriangle = 12 * BytesOfNumber + 2;

/// The lowest byte first, whatever the system's order is.
void SetBytes(char* bytes, std::uint32_t bits)
{
  for (std::size_t i = 0; i < BytesOfNumber; ++i)
  {
    bytes[i] = static_cast<char>(bits >> (8 * i) & 255U);
  }
}

void SetVector(char* bytes, const std::array<double, 3>& vector)
{
  for (std::size_t i = 0; i < vector.size(); ++i)
  {
    const float single = static_cast<float>(vector[i]);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &single, sizeof(bits));
    SetBytes(bytes + i * BytesOfNumber, bits);
  }
}

std::array<char, BytesOfHeader + BytesOfNumber> MakeHeader(vtkPolyData* surface)
{
  const std::string frame = FrameOf(surface);
  const std::string text =
    frame.empty() ? "Visualization Toolkit generated SLA File" : FrameLine(frame);
  std::array<char, BytesOfHeader + BytesOfNumber> header{};
  text.copy(header.data(), BytesOfHeader);
  SetBytes(header.data() + BytesOfHeader, static_cast<std::uint32_t>(surface->GetNumberOfPolys()));
  return header;
}

std::array<char, BytesOfTriangle> MakeTriangle(vtkPoints* points, const vtkIdType* corners)
{
  std::array<std::array<double, 3>, 3> positions;
  for (std::size_t i = 0; i < 3; ++i)
  {
    points->GetPoint(corners[i], positions[i].data());
  }
  std::array<double, 3> normal;
  vtkTriangle::ComputeNormal(
    positions[0].data(), positions[1].data(), positions[2].data(), normal.data());
  std::array<char, BytesOfTriangle> triangle{};
  SetVector(triangle.data(), normal);
  for (std::size_t i = 0; i < 3; ++i)
  {
    SetVector(triangle.data() + (i + 1) * 3 * BytesOfNumber, positions[i]);
  }
  return triangle;
}
}

void WriteStlFile(vtkPolyData* surface, const std::string& path)
{
  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  const auto header = MakeHeader(surface);
  stream.write(header.data(), header.size());
  const auto face = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (face->GoToFirstCell(); !face->IsDoneWithTraversal(); face->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    face->GetCurrentCell(size, corners);
    if (size != 3)
    {
      throw Failure(ExitCode::CouldNotWrite, "STL holds triangles alone");
    }
    const auto triangle = MakeTriangle(surface->GetPoints(), corners);
    stream.write(triangle.data(), triangle.size());
  }
  stream.close();
  if (!stream)
  {
    throw Failure(ExitCode::CouldNotWrite, WriteProblem());
  }
}
}
