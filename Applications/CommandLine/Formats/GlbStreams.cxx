// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER

#include "GlbStreams.h"

#include "GlbFiles.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr int UnsignedByte = 5121;
constexpr int UnsignedShort = 5123;
constexpr int Single = 5126;

template <typename Number>
void Put(Number number, std::string& bytes)
{
  const auto* const first = reinterpret_cast<const char*>(&number);
  bytes.append(first, sizeof(Number));
}

/// Colors that the run or the input gave the points; null: none.
vtkUnsignedCharArray* ColorsOf(vtkPolyData* surface)
{
  for (const char* name : { VertexColorArray, "RGBA", "RGB" })
  {
    auto* const colors =
      vtkUnsignedCharArray::SafeDownCast(surface->GetPointData()->GetAbstractArray(name));
    if (colors != nullptr &&
      (colors->GetNumberOfComponents() == 3 || colors->GetNumberOfComponents() == 4))
    {
      return colors;
    }
  }
  return nullptr;
}

bool IsFinite(vtkDataArray* array, bool mayVanish)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    double square = 0.0;
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      square += array->GetComponent(i, k) * array->GetComponent(i, k);
    }
    if (!std::isfinite(square) || (!mayVanish && square < 1e-12))
    {
      return false;
    }
  }
  return true;
}

/// glTF wants normals of length 1.
vtkDataArray* NormalsOf(vtkPolyData* surface)
{
  vtkDataArray* const normals = surface->GetPointData()->GetNormals();
  return normals != nullptr && normals->GetNumberOfComponents() == 3 && IsFinite(normals, false)
    ? normals
    : nullptr;
}

vtkDataArray* TextureOf(vtkPolyData* surface)
{
  vtkDataArray* const texture = surface->GetPointData()->GetTCoords();
  return texture != nullptr && texture->GetNumberOfComponents() == 2 && IsFinite(texture, true)
    ? texture
    : nullptr;
}

GlbAttribute PositionsOf(const FilePart& part, const std::optional<PointGrid>& grid)
{
  GlbAttribute positions;
  positions.Name = "POSITION";
  positions.ComponentType = grid ? UnsignedShort : Single;
  positions.Stream.Stride = grid ? 8 : 12; // glTF wants multiples of four bytes
  positions.Least.assign(3, HUGE_VAL);
  positions.Most.assign(3, -HUGE_VAL);
  for (const std::array<double, 3>& point : part.Points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      double number = static_cast<double>(static_cast<float>(point[axis]));
      if (grid)
      {
        number = std::round((point[axis] - grid->Origin[axis]) / grid->Step);
        Put(static_cast<std::uint16_t>(number), positions.Stream.Bytes);
      }
      else
      {
        Put(static_cast<float>(number), positions.Stream.Bytes);
      }
      positions.Least[axis] = std::min(positions.Least[axis], number);
      positions.Most[axis] = std::max(positions.Most[axis], number);
    }
    if (grid)
    {
      Put(std::uint16_t(0), positions.Stream.Bytes);
    }
  }
  return positions;
}

GlbAttribute ColorAttribute(const FilePart& part, vtkUnsignedCharArray* colors)
{
  GlbAttribute attribute;
  attribute.Name = "COLOR_0";
  attribute.ComponentType = UnsignedByte;
  attribute.Components = 4;
  attribute.IsNormalized = true;
  for (const vtkIdType point : part.OriginalPoints)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const unsigned char byte = colors->GetTypedComponent(point, channel);
      Put(
        static_cast<std::uint8_t>(std::lround(255.0 * LinearColor(byte))), attribute.Stream.Bytes);
    }
    const bool hasAlpha = colors->GetNumberOfComponents() == 4;
    Put(hasAlpha ? colors->GetTypedComponent(point, 3) : std::uint8_t(UINT8_MAX),
      attribute.Stream.Bytes);
  }
  return attribute;
}

GlbAttribute NormalAttribute(const FilePart& part, vtkDataArray* normals)
{
  GlbAttribute attribute;
  attribute.Name = "NORMAL";
  attribute.ComponentType = Single;
  attribute.Stream.Stride = 12;
  for (const vtkIdType point : part.OriginalPoints)
  {
    std::array<double, 3> normal = {};
    normals->GetTuple(point, normal.data());
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (const double coordinate : normal)
    {
      Put(static_cast<float>(coordinate / length), attribute.Stream.Bytes);
    }
  }
  return attribute;
}

/// From the upper left, while those of other formats are from the lower left.
GlbAttribute TextureAttribute(const FilePart& part, vtkDataArray* texture)
{
  GlbAttribute attribute;
  attribute.Name = "TEXCOORD_0";
  attribute.ComponentType = Single;
  attribute.Components = 2;
  attribute.Stream.Stride = 8;
  for (const vtkIdType point : part.OriginalPoints)
  {
    Put(static_cast<float>(texture->GetComponent(point, 0)), attribute.Stream.Bytes);
    Put(static_cast<float>(1.0 - texture->GetComponent(point, 1)), attribute.Stream.Bytes);
  }
  return attribute;
}
}

double LinearColor(unsigned char byte)
{
  const double value = byte / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::vector<GlbAttribute> AttributesOf(
  vtkPolyData* surface, const FilePart& part, const std::optional<PointGrid>& grid)
{
  std::vector<GlbAttribute> attributes = { PositionsOf(part, grid) };
  if (vtkDataArray* const normals = NormalsOf(surface))
  {
    attributes.push_back(NormalAttribute(part, normals));
  }
  if (vtkDataArray* const texture = TextureOf(surface))
  {
    attributes.push_back(TextureAttribute(part, texture));
  }
  if (vtkUnsignedCharArray* const colors = ColorsOf(surface))
  {
    attributes.push_back(ColorAttribute(part, colors));
  }
  return attributes;
}

//------------------------------------------------------------------------------
std::set<std::string> ArraysOfGlb(vtkPolyData* surface)
{
  std::set<std::string> names = { "BoundaryLabels", "LabelValues", "LabelNames", "LabelColors",
    "Color", VertexColorArray };
  for (vtkDataArray* const array :
    { NormalsOf(surface), TextureOf(surface), static_cast<vtkDataArray*>(ColorsOf(surface)) })
  {
    if (array != nullptr && array->GetName() != nullptr)
    {
      names.insert(array->GetName());
    }
  }
  return names;
}
}

#endif
