// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileParts.h"

#include "CoordinateCollector.h"
#include "LabelMapArrays.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace bonedecimate
{
namespace
{
using Corners = std::array<vtkIdType, 3>;
using Position = std::array<double, 3>;

/// All triangles, in the order of the polygons; polygons of more corners are no triangles and left
/// out.
std::vector<Corners> TrianglesOf(vtkPolyData* surface)
{
  std::vector<Corners> triangles;
  const auto cell = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(size, corners);
    if (size == 3)
    {
      triangles.push_back({ corners[0], corners[1], corners[2] });
    }
  }
  return triangles;
}

/// Collects the triangles of a part and numbers its points in the order of their first use.
class PartBuilder
{
public:
  explicit PartBuilder(vtkPolyData* surface)
    : Surface(surface)
    , Numbers(static_cast<std::size_t>(surface->GetNumberOfPoints()), None)
  {
  }

  void Add(const Corners& corners)
  {
    for (const vtkIdType point : corners)
    {
      std::uint32_t& number = this->Numbers[static_cast<std::size_t>(point)];
      if (number == None)
      {
        number = static_cast<std::uint32_t>(this->Part.Points.size());
        this->Part.Points.emplace_back();
        this->Surface->GetPoint(point, this->Part.Points.back().data());
        this->Part.OriginalPoints.push_back(point);
      }
      this->Part.Corners.push_back(number);
    }
  }

  /// The part; the next one starts empty.
  FilePart Take()
  {
    for (const vtkIdType point : this->Part.OriginalPoints)
    {
      this->Numbers[static_cast<std::size_t>(point)] = None;
    }
    return std::exchange(this->Part, FilePart());
  }

private:
  static constexpr std::uint32_t None = UINT32_MAX;
  vtkPolyData* Surface;
  std::vector<std::uint32_t> Numbers; // of the points of the surface in the part
  FilePart Part;
};

std::int64_t LabelAt(vtkDataArray* labels, vtkIdType cell, int side)
{
  if (auto* exact = vtkAOSDataArrayTemplate<long long>::FastDownCast(labels))
  {
    return exact->GetTypedComponent(cell, side);
  }
  if (auto* exact = vtkAOSDataArrayTemplate<long>::FastDownCast(labels))
  {
    return exact->GetTypedComponent(cell, side);
  }
  return static_cast<std::int64_t>(labels->GetComponent(cell, side));
}

bool HasArray(const FilePart& part, const std::string& name, const PartArray& like)
{
  const auto found = part.Arrays.find(name);
  return found != part.Arrays.end() && found->second.Components == like.Components &&
    found->second.Type == like.Type;
}

/// The arrays that all parts have in the same form, empty.
std::vector<vtkSmartPointer<vtkDataArray>> CommonArrays(const std::vector<FilePart>& parts)
{
  std::vector<vtkSmartPointer<vtkDataArray>> arrays;
  if (parts.empty())
  {
    return arrays;
  }
  for (const auto& [name, like] : parts.front().Arrays)
  {
    const auto has = [&name = name, &like = like](const FilePart& part)
    { return HasArray(part, name, like); };
    if (std::all_of(parts.begin(), parts.end(), has))
    {
      vtkSmartPointer<vtkDataArray> array;
      array.TakeReference(vtkDataArray::CreateDataArray(like.Type));
      array->SetName(name.c_str());
      array->SetNumberOfComponents(like.Components);
      arrays.push_back(array);
    }
  }
  return arrays;
}

/// From parts to one surface.
class Joiner
{
public:
  Joiner(bool mergesPoints, const std::vector<FilePart>& parts)
    : MergesPoints(mergesPoints)
    , Arrays(CommonArrays(parts))
  {
    this->Sides->SetName(BoundaryLabelsName);
    this->Sides->SetNumberOfComponents(2);
  }

  void Add(const FilePart& part, std::int64_t label, std::int64_t background)
  {
    std::vector<vtkIdType> numbers;
    numbers.reserve(part.Points.size());
    for (std::size_t i = 0; i < part.Points.size(); ++i)
    {
      const vtkIdType next = this->Coordinates.CountPoints();
      numbers.push_back(this->NumberOf(part.Points[i]));
      if (numbers.back() == next)
      {
        this->AddValues(part, i);
      }
    }
    for (std::size_t i = 0; i + 2 < part.Corners.size(); i += 3)
    {
      const Corners corners = { numbers[part.Corners[i]], numbers[part.Corners[i + 1]],
        numbers[part.Corners[i + 2]] };
      this->AddTriangle(corners, label, background);
    }
  }

  vtkSmartPointer<vtkPolyData> Take(bool withLabels)
  {
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(this->Coordinates.MakePoints());
    surface->SetPolys(this->Cells);
    if (withLabels)
    {
      surface->GetCellData()->AddArray(this->Sides);
    }
    const std::pair<const char*, int> roles[] = { { "Normals", vtkDataSetAttributes::NORMALS },
      { "TCoords", vtkDataSetAttributes::TCOORDS }, { "RGB", vtkDataSetAttributes::SCALARS },
      { "RGBA", vtkDataSetAttributes::SCALARS } };
    for (const vtkSmartPointer<vtkDataArray>& array : this->Arrays)
    {
      surface->GetPointData()->AddArray(array);
      for (const auto& [name, role] : roles)
      {
        if (std::string(array->GetName()) == name)
        {
          surface->GetPointData()->SetActiveAttribute(name, role);
        }
      }
    }
    return surface;
  }

private:
  /// Adds the values of a new point.
  void AddValues(const FilePart& part, std::size_t point)
  {
    for (const vtkSmartPointer<vtkDataArray>& array : this->Arrays)
    {
      const PartArray& values = part.Arrays.at(array->GetName());
      array->InsertNextTuple(
        values.Values.data() + point * static_cast<std::size_t>(values.Components));
    }
  }

  vtkIdType NumberOf(const Position& position)
  {
    const vtkIdType next = this->Coordinates.CountPoints();
    if (this->MergesPoints)
    {
      const auto [known, isNew] = this->Known.emplace(position, next);
      if (!isNew)
      {
        return known->second;
      }
    }
    for (const double coordinate : position)
    {
      this->Coordinates.Add(coordinate);
    }
    return next;
  }

  void AddTriangle(const Corners& corners, std::int64_t label, std::int64_t background)
  {
    Corners sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    const vtkIdType next = this->Cells->GetNumberOfCells();
    const auto wall = this->MergesPoints ? this->Single.find(sorted) : this->Single.end();
    if (wall != this->Single.end() && this->Sides->GetTypedComponent(wall->second, 0) != label)
    {
      this->Sides->SetTypedComponent(wall->second, 1, label);
      this->Single.erase(wall);
      return;
    }
    this->Cells->InsertNextCell(3, corners.data());
    const std::array<vtkTypeInt64, 2> sides = { label, background };
    this->Sides->InsertNextTypedTuple(sides.data());
    if (this->MergesPoints)
    {
      this->Single.emplace(sorted, next);
    }
  }

  const bool MergesPoints;
  const std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  CoordinateCollector Coordinates;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkTypeInt64Array> Sides;
  std::map<Position, vtkIdType> Known;
  std::map<Corners, vtkIdType> Single; // triangles that one part has so far
};
}

std::vector<FilePart> PartsOf(vtkPolyData* surface)
{
  const std::vector<Corners> triangles = TrianglesOf(surface);
  vtkDataArray* const sides = surface->GetCellData()->GetArray(BoundaryLabelsName);
  // before those of triangles
  const vtkIdType firstCell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  std::vector<NamedLabel> labels = LabelsOf(surface);
  PartBuilder builder(surface);
  std::vector<FilePart> parts;
  if (sides == nullptr || labels.empty() || sides->GetNumberOfComponents() != 2 ||
    sides->GetNumberOfTuples() != firstCell + static_cast<vtkIdType>(triangles.size()))
  {
    std::for_each(
      triangles.begin(), triangles.end(), [&](const Corners& corners) { builder.Add(corners); });
    parts.push_back(builder.Take());
    return parts;
  }
  for (const NamedLabel& label : WithColors(std::move(labels)))
  {
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      const vtkIdType cell = firstCell + static_cast<vtkIdType>(i);
      const Corners& c = triangles[i];
      if (LabelAt(sides, cell, 0) == label.Value)
      {
        builder.Add(c);
      }
      else if (LabelAt(sides, cell, 1) == label.Value)
      {
        builder.Add({ c[0], c[2], c[1] });
      }
    }
    FilePart part = builder.Take();
    part.Label = label;
    if (!part.Corners.empty())
    {
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> JoinParts(const std::vector<FilePart>& parts)
{
  const bool hasLabels = !parts.empty() &&
    std::all_of(
      parts.begin(), parts.end(), [](const FilePart& part) { return part.Label.has_value(); });
  std::vector<NamedLabel> labels;
  std::int64_t background = 0;
  for (const FilePart& part : parts)
  {
    if (hasLabels)
    {
      labels.push_back(*part.Label);
      background = std::min(background, part.Label->Value - 1);
    }
  }
  Joiner joiner(hasLabels, parts);
  for (const FilePart& part : parts)
  {
    joiner.Add(part, hasLabels ? part.Label->Value : 0, background);
  }
  const vtkSmartPointer<vtkPolyData> surface = joiner.Take(hasLabels);
  if (hasLabels)
  {
    NamedLabel outside;
    outside.Value = background;
    labels.push_back(outside);
    WriteNamedLabels(labels, surface->GetFieldData());
  }
  return surface;
}

//------------------------------------------------------------------------------
std::vector<std::string> ArraysOfSomeParts(const std::vector<FilePart>& parts)
{
  std::set<std::string> names;
  for (const FilePart& part : parts)
  {
    for (const auto& [name, values] : part.Arrays)
    {
      names.insert(name);
    }
  }
  for (const vtkSmartPointer<vtkDataArray>& array : CommonArrays(parts))
  {
    names.erase(array->GetName());
  }
  return { names.begin(), names.end() };
}

//------------------------------------------------------------------------------
bool IsClosed(const FilePart& part)
{
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Edge> edges;
  edges.reserve(part.Corners.size());
  for (std::size_t i = 0; i + 2 < part.Corners.size(); i += 3)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      edges.emplace_back(part.Corners[i + k], part.Corners[i + (k + 1) % 3]);
    }
  }
  std::sort(edges.begin(), edges.end());
  const bool isOnce = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  return isOnce &&
    std::all_of(edges.begin(), edges.end(),
      [&edges](const Edge& edge) {
        return std::binary_search(edges.begin(), edges.end(), Edge{ edge.second, edge.first });
      });
}
}
