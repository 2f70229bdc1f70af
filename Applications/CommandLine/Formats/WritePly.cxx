// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WritePly.h"

#include "ExitCode.h"
#include "NamedLabels.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cstdint>
#include <cstring>
#include <fstream>

namespace bonedecimate
{
namespace
{
constexpr vtkIdType MostCorners = 255; // what the count of a polygon can be, one byte

class PlyWriter
{
public:
  PlyWriter(vtkPolyData* surface, const std::string& path)
    : Surface(surface)
    , Stream(path, std::ios::binary | std::ios::trunc)
    , Coordinates(surface->GetPoints()->GetData())
    , Texture(surface->GetPointData()->GetTCoords())
    , Colors(ColorsOf(surface))
  {
    if (this->Texture && this->Texture->GetNumberOfComponents() != 2)
    {
      this->Texture = nullptr;
    }
  }

  void Run()
  {
    this->WriteHeader();
    for (vtkIdType point = 0; point < this->Surface->GetNumberOfPoints(); ++point)
    {
      this->WriteTuple(this->Coordinates, point);
      if (this->Texture)
      {
        this->WriteTuple(this->Texture, point);
      }
    }
    this->WriteFaces();
    this->Stream.close();
    if (!this->Stream)
    {
      throw Failure(ExitCode::CouldNotWrite, "the file is not complete, the disk may be full");
    }
  }

private:
  /// Three bytes for each cell, which begin with vertices and lines; null if there are none.
  static vtkUnsignedCharArray* ColorsOf(vtkPolyData* surface)
  {
    auto* const colors =
      vtkUnsignedCharArray::SafeDownCast(surface->GetCellData()->GetArray(ColorArray));
    return colors && colors->GetNumberOfComponents() == 3 ? colors : nullptr;
  }

  static bool IsDouble(vtkDataArray* array) { return array->GetDataType() == VTK_DOUBLE; }

  void WriteProperties(vtkDataArray* array, const char* const* names)
  {
    for (int i = 0; i < array->GetNumberOfComponents(); ++i)
    {
      this->Stream << "property " << (IsDouble(array) ? "double " : "float ") << names[i] << "\n";
    }
  }

  void WriteHeader()
  {
    static const char* const axes[] = { "x", "y", "z" };
    static const char* const texture[] = { "u", "v" };
    this->Stream << "ply\nformat binary_little_endian 1.0\ncomment VTK generated PLY File\n"
                 << "obj_info vtkPolyData points and polygons: vtk4.0\nelement vertex "
                 << std::to_string(this->Surface->GetNumberOfPoints()) << "\n";
    this->WriteProperties(this->Coordinates, axes);
    if (this->Texture)
    {
      this->WriteProperties(this->Texture, texture);
    }
    this->Stream << "element face " << std::to_string(this->Surface->GetPolys()->GetNumberOfCells())
                 << "\nproperty list uchar int vertex_indices\n"
                 << (this->Colors
                        ? "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                        : "")
                 << "end_header\n";
  }

  void WriteTuple(vtkDataArray* array, vtkIdType tuple)
  {
    for (int i = 0; i < array->GetNumberOfComponents(); ++i)
    {
      const double value = array->GetComponent(tuple, i);
      const float single = static_cast<float>(value);
      std::uint64_t bits = 0;
      std::uint32_t bitsOfSingle = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      std::memcpy(&bitsOfSingle, &single, sizeof(bitsOfSingle));
      const bool isDouble = IsDouble(array);
      this->WriteBits(isDouble ? bits : bitsOfSingle, isDouble ? 8 : 4);
    }
  }

  void WriteFaces()
  {
    vtkIdType cell = this->Surface->GetNumberOfVerts() + this->Surface->GetNumberOfLines();
    const auto face = vtk::TakeSmartPointer(this->Surface->GetPolys()->NewIterator());
    for (face->GoToFirstCell(); !face->IsDoneWithTraversal(); face->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      face->GetCurrentCell(size, corners);
      if (size > MostCorners)
      {
        throw Failure(ExitCode::CouldNotWrite, "a polygon has more than 255 corners");
      }
      this->WriteBits(static_cast<std::uint64_t>(size), 1);
      for (vtkIdType i = 0; i < size; ++i)
      {
        this->WriteBits(static_cast<std::uint64_t>(corners[i]), 4);
      }
      for (int i = 0; this->Colors && i < 3; ++i)
      {
        this->WriteBits(this->Colors->GetTypedComponent(cell, i), 1);
      }
      ++cell;
    }
  }

  /// The lowest first, whatever the system's order is.
  void WriteBits(std::uint64_t bits, int bytes)
  {
    char raw[8] = {};
    for (int i = 0; i < bytes; ++i)
    {
      raw[i] = static_cast<char>(bits >> (8 * i) & 255U);
    }
    this->Stream.write(raw, bytes);
  }

  vtkPolyData* Surface;
  std::ofstream Stream;
  vtkDataArray* Coordinates;
  vtkDataArray* Texture;
  vtkUnsignedCharArray* Colors;
};
}

void WritePlyFile(vtkPolyData* surface, const std::string& path)
{
  PlyWriter(surface, path).Run();
}
}
