// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerMesh.h"

#include "PageParts.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkZLibDataCompressor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace bonedecimate
{
namespace
{
constexpr double LargestStep = 65535.0;     // 16 bits
constexpr double LargestCode = 255.0;       // 8 bits
constexpr double LargestCodeWithin = 127.0; // a tolerance
constexpr vtkIdType None = -1;

/// Seven bits a byte, the low ones first; the high bit says that more follow.
void AppendVarint(std::uint64_t value, std::string& bytes)
{
  for (; value >= 0x80; value >>= 7)
  {
    bytes += static_cast<char>((value & 0x7f) | 0x80);
  }
  bytes += static_cast<char>(value);
}

/// The sign is the lowest bit.
void AppendSigned(std::int64_t value, std::string& bytes)
{
  AppendVarint(static_cast<std::uint64_t>(value < 0 ? -2 * value - 1 : 2 * value), bytes);
}

std::string Compressed(const std::string& bytes)
{
  vtkNew<vtkZLibDataCompressor> zlib;
  zlib->SetCompressionLevel(6);
  std::string result(zlib->GetMaximumCompressionSpace(bytes.size()), '\0');
  result.resize(zlib->Compress(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
    reinterpret_cast<unsigned char*>(result.data()), result.size()));
  return result;
}

/// Writes the pieces of one surface.
class PieceWriter
{
public:
  PieceWriter(
    vtkPolyData* triangles, const QuantizationGrid& grid, const QuantizedDistances& distances)
    : Surface(triangles)
    , Grid(grid)
    , Range(distances.Range)
    , Tolerance(distances.Tolerance)
    , Distances(triangles->GetPointData()->GetArray(distances.ArrayName.c_str()))
    , IndexOfPoint(static_cast<std::size_t>(triangles->GetNumberOfPoints()), None)
  {
  }

  EncodedPiece Write(const ViewerPiece& piece)
  {
    const std::string triangles = this->Triangles(piece);
    this->WritePoints();
    this->Bytes += triangles;
    this->WriteDistances();
    const EncodedPiece written = { piece.Parts, static_cast<vtkIdType>(this->Points.size()),
      static_cast<vtkIdType>(piece.Triangles.size()) };
    for (const vtkIdType point : this->Points)
    {
      this->IndexOfPoint[static_cast<std::size_t>(point)] = None;
    }
    this->Points.clear();
    return written;
  }

  const std::string& GetBytes() const { return this->Bytes; }
  bool HasDistances() const { return this->Distances != nullptr; }

private:
  /// Each corner as its distance from the next point that no triangle before uses.
  std::string Triangles(const ViewerPiece& piece)
  {
    std::string bytes;
    vtkNew<vtkIdList> corners;
    for (const vtkIdType triangle : piece.Triangles)
    {
      this->Surface->GetPolys()->GetCellAtId(triangle, corners);
      for (vtkIdType i = 0; i < 3; ++i)
      {
        const auto next = static_cast<vtkIdType>(this->Points.size());
        vtkIdType& index = this->IndexOfPoint[static_cast<std::size_t>(corners->GetId(i))];
        if (index == None)
        {
          index = next;
          this->Points.push_back(corners->GetId(i));
        }
        AppendVarint(static_cast<std::uint64_t>(next - index), bytes);
      }
    }
    return bytes;
  }

  void WritePoints()
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::int64_t previous = 0;
      for (const vtkIdType point : this->Points)
      {
        const double offset = this->Surface->GetPoint(point)[axis] - this->Grid.Origin[axis];
        const double steps = std::clamp(offset / this->Grid.Step, 0.0, LargestStep);
        const std::int64_t coordinate = std::llround(steps);
        AppendSigned(coordinate - previous, this->Bytes);
        previous = coordinate;
      }
    }
  }

  void WriteDistances()
  {
    if (!this->Distances)
    {
      return;
    }
    for (const vtkIdType point : this->Points)
    {
      const double distance = this->Distances->GetComponent(point, 0);
      const double code = LargestCode * (std::isfinite(distance) ? distance : 0.0) / this->Range;
      // A distance equal to the tolerance is single precision here.
      const bool isWithin = distance <= static_cast<float>(this->Tolerance);
      const double least = this->Tolerance > 0.0 && !isWithin ? LargestCodeWithin + 1.0 : 0.0;
      const double most = this->Tolerance > 0.0 && isWithin ? LargestCodeWithin : LargestCode;
      this->Bytes += static_cast<char>(static_cast<int>(std::clamp(code, least, most)));
    }
  }

  vtkPolyData* Surface;
  const QuantizationGrid& Grid;
  double Range;
  double Tolerance;
  vtkDataArray* Distances;
  std::vector<vtkIdType> IndexOfPoint; // of the surface, in the piece
  std::vector<vtkIdType> Points;       // of the piece
  std::string Bytes;
};
}

QuantizationGrid::QuantizationGrid(const vtkBoundingBox& box)
  : Origin{ box.GetBound(0), box.GetBound(2), box.GetBound(4) }
  , Step(box.GetMaxLength() > 0.0 ? box.GetMaxLength() / LargestStep : 1.0)
{
}

EncodedSurface EncodeSurface(vtkPolyData* triangles, const std::vector<ViewerPiece>& pieces,
  const QuantizationGrid& grid, const QuantizedDistances& distances)
{
  PieceWriter writer(triangles, grid, distances);
  EncodedSurface surface;
  for (const ViewerPiece& piece : pieces)
  {
    surface.Pieces.push_back(writer.Write(piece));
  }
  surface.HasDistances = writer.HasDistances();
  surface.Base64 = Base64(Compressed(writer.GetBytes()));
  return surface;
}
}
