// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelArrays.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bonedecimate
{
namespace
{
/// The tuples of an array, numbered.
struct Tuples
{
  std::vector<Index> Ids;       // of each tuple
  std::vector<vtkIdType> First; // tuple of each id
  std::vector<std::string> Names;
};

std::string NameOf(const std::vector<std::int64_t>& tuple)
{
  std::string name;
  for (const std::int64_t value : tuple)
  {
    name += (name.empty() ? "" : "_") + std::to_string(value);
  }
  return name;
}

/// Nothing if a value is no whole number.
std::optional<Tuples> Number(vtkDataArray* array)
{
  constexpr double largest = 9007199254740992.0; // beyond, doubles leave whole numbers out
  std::map<std::vector<std::int64_t>, Index> known;
  std::vector<const Index*> ids; // in the map, where they are numbered when all are known
  std::vector<std::int64_t> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (std::size_t k = 0; k < tuple.size(); ++k)
    {
      const double value = array->GetComponent(i, static_cast<int>(k));
      if (!(std::abs(value) <= largest) || std::floor(value) != value)
      {
        return {};
      }
      tuple[k] = static_cast<std::int64_t>(value);
    }
    ids.push_back(&known.emplace(tuple, 0).first->second);
  }
  Tuples numbered;
  for (auto& [values, id] : known)
  {
    id = static_cast<Index>(numbered.Names.size());
    numbered.Names.push_back(NameOf(values));
  }
  numbered.Ids.reserve(ids.size());
  numbered.First.assign(numbered.Names.size(), -1);
  for (const Index* id : ids)
  {
    vtkIdType& first = numbered.First[static_cast<std::size_t>(*id)];
    first = first < 0 ? static_cast<vtkIdType>(numbered.Ids.size()) : first;
    numbered.Ids.push_back(*id);
  }
  return numbered;
}

Index Majority(Index a, Index b, Index c)
{
  return b == c ? b : a == b || a == c ? a : std::min({ a, b, c });
}

struct LabelsOfTriangles
{
  Tuples All;
  std::vector<Index> Ids; // of each triangle
};

/// Nothing if the array does not suit.
std::optional<LabelsOfTriangles> ReadTuples(
  vtkPolyData* input, const ConvertedSurface& converted, vtkDataArray* array, int association)
{
  const bool isOfCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const bool isOfPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  if (!array || !(isOfCells || isOfPoints))
  {
    return {};
  }
  const vtkIdType needed = isOfCells ? input->GetNumberOfCells() : input->GetNumberOfPoints();
  std::optional<Tuples> tuples =
    array->GetNumberOfTuples() >= needed ? Number(array) : std::optional<Tuples>();
  if (!tuples)
  {
    return {};
  }
  LabelsOfTriangles labels;
  const auto at = [&](Index point) // ids out of range are rejected later
  { return point < 0 || point >= needed ? 0 : tuples->Ids[static_cast<std::size_t>(point)]; };
  for (std::size_t t = 0; t < converted.Surface.Triangles.size(); ++t)
  {
    const Triangle& c = converted.Surface.Triangles[t];
    labels.Ids.push_back(isOfCells ? tuples->Ids[static_cast<std::size_t>(converted(t))]
                                   : Majority(at(c[0]), at(c[1]), at(c[2])));
  }
  labels.All = std::move(*tuples);
  return labels;
}
}

std::optional<Labels> ReadLabels(
  vtkPolyData* input, const ConvertedSurface& converted, vtkDataArray* array, int association)
{
  std::optional<LabelsOfTriangles> read = ReadTuples(input, converted, array, association);
  if (!read)
  {
    return {};
  }
  Labels labels;
  labels.Names = std::move(read->All.Names);
  labels.OfTriangle = std::move(read->Ids);
  return labels;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> LabelsOfCells(
  vtkPolyData* input, const ConvertedSurface& converted, vtkDataArray* array, int association)
{
  const std::optional<LabelsOfTriangles> read = ReadTuples(input, converted, array, association);
  if (!read)
  {
    return nullptr;
  }
  const auto labels = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  labels->SetNumberOfComponents(array->GetNumberOfComponents());
  labels->SetNumberOfTuples(input->GetNumberOfCells());
  labels->Fill(0.0);
  for (std::size_t t = 0; t < read->Ids.size(); ++t)
  {
    const auto id = static_cast<std::size_t>(read->Ids[t]);
    labels->SetTuple(converted(t), read->All.First[id], array);
  }
  return labels;
}
}
