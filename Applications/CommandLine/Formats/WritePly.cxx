// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WritePly.h"

#include "ExitCode.h"
#include "FileFrame.h"
#include "PlyColumns.h"
#include "TextOutput.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace bonedecimate
{
namespace
{
constexpr vtkIdType MaxCorners = 255; // what the count of a polygon can be, one byte

class PlyWriter
{
public:
  PlyWriter(vtkPolyData* surface, const std::string& path)
    : Surface(surface)
    , Coordinates(surface->GetPoints()->GetData())
    , OfPoints(PointColumns(surface))
    , OfFaces(FaceColumns(surface))
  {
    errno = 0;
    this->Stream.open(path, std::ios::binary | std::ios::trunc);
  }

  void Run()
  {
    this->WriteHeader();
    for (vtkIdType point = 0; point < this->Surface->GetNumberOfPoints(); ++point)
    {
      this->WriteTuple(this->Coordinates, point);
      this->WriteTuples(this->OfPoints, point);
    }
    this->WriteFaces();
    this->Stream.close();
    if (!this->Stream)
    {
      throw Failure(ExitCode::CouldNotWrite, WriteProblem());
    }
  }

private:
  void WriteProperties(const PlyColumn& column)
  {
    for (const std::string& name : column.Properties)
    {
      this->Stream << "property " << PlyTypeName(column.Array->GetDataType()) << " " << name
                   << "\n";
    }
  }

  void WriteHeader()
  {
    const std::string frame = FrameOf(this->Surface);
    this->Stream << "ply\nformat binary_little_endian 1.0\ncomment "
                 << (frame.empty() ? "VTK generated PLY File" : FrameLine(frame))
                 << "\nobj_info vtkPolyData points and polygons: vtk4.0\nelement vertex "
                 << std::to_string(this->Surface->GetNumberOfPoints()) << "\n";
    this->WriteProperties({ this->Coordinates, { "x", "y", "z" } });
    for (const PlyColumn& column : this->OfPoints)
    {
      this->WriteProperties(column);
    }
    this->Stream << "element face " << std::to_string(this->Surface->GetPolys()->GetNumberOfCells())
                 << "\nproperty list uchar int vertex_indices\n";
    for (const PlyColumn& column : this->OfFaces)
    {
      this->WriteProperties(column);
    }
    this->Stream << "end_header\n";
  }

  void WriteTuples(const std::vector<PlyColumn>& columns, vtkIdType tuple)
  {
    for (const PlyColumn& column : columns)
    {
      this->WriteTuple(column.Array, tuple);
    }
  }

  void WriteTuple(vtkDataArray* array, vtkIdType tuple)
  {
    const int bytes = array->GetDataTypeSize();
    for (int i = 0; i < array->GetNumberOfComponents(); ++i)
    {
      const double value = array->GetComponent(tuple, i);
      const float single = static_cast<float>(value);
      std::uint64_t bits = 0;
      std::uint32_t bitsOfSingle = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      std::memcpy(&bitsOfSingle, &single, sizeof(bitsOfSingle));
      switch (array->GetDataType())
      {
        case VTK_DOUBLE:
          this->WriteBits(bits, bytes);
          break;
        case VTK_FLOAT:
          this->WriteBits(bitsOfSingle, bytes);
          break;
        default:
          this->WriteBits(static_cast<std::uint64_t>(static_cast<std::int64_t>(value)), bytes);
      }
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
      if (size > MaxCorners)
      {
        throw Failure(ExitCode::CouldNotWrite, "a polygon has more than 255 corners");
      }
      this->WriteBits(static_cast<std::uint64_t>(size), 1);
      for (vtkIdType i = 0; i < size; ++i)
      {
        this->WriteBits(static_cast<std::uint64_t>(corners[i]), 4);
      }
      this->WriteTuples(this->OfFaces, cell);
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
  std::vector<PlyColumn> OfPoints;
  std::vector<PlyColumn> OfFaces;
};
}

void WritePlyFile(vtkPolyData* surface, const std::string& path)
{
  PlyWriter(surface, path).Run();
}
}
