// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
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
  std::vector<Index> Ids; // of each tuple
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
  std::vector<std::vector<std::int64_t>> tuples;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    std::vector<std::int64_t> tuple;
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      const double value = array->GetComponent(i, k);
      if (!(std::abs(value) <= largest) || std::floor(value) != value)
      {
        return {};
      }
      tuple.push_back(static_cast<std::int64_t>(value));
    }
    known.emplace(tuple, 0);
    tuples.push_back(std::move(tuple));
  }
  Tuples numbered;
  for (auto& [tuple, id] : known)
  {
    id = static_cast<Index>(numbered.Names.size());
    numbered.Names.push_back(NameOf(tuple));
  }
  for (const std::vector<std::int64_t>& tuple : tuples)
  {
    numbered.Ids.push_back(known[tuple]);
  }
  return numbered;
}

Index Majority(Index a, Index b, Index c)
{
  return b == c ? b : a == b || a == c ? a : std::min({ a, b, c });
}
}

std::optional<Labels> ReadLabels(
  vtkPolyData* input, const ConvertedSurface& converted, const std::string& name)
{
  vtkDataArray* cells = input->GetCellData()->GetArray(name.c_str());
  vtkDataArray* points = cells ? nullptr : input->GetPointData()->GetArray(name.c_str());
  vtkDataArray* array = cells ? cells : points;
  const vtkIdType needed = cells ? input->GetNumberOfCells() : input->GetNumberOfPoints();
  std::optional<Tuples> tuples =
    array && array->GetNumberOfTuples() >= needed ? Number(array) : std::optional<Tuples>();
  if (!tuples)
  {
    return {};
  }
  Labels labels;
  labels.Names = std::move(tuples->Names);
  const auto at = [&](Index point) // ids out of range are refused later
  { return point < 0 || point >= needed ? 0 : tuples->Ids[static_cast<std::size_t>(point)]; };
  for (std::size_t t = 0; t < converted.Surface.Triangles.size(); ++t)
  {
    const Triangle& c = converted.Surface.Triangles[t];
    labels.OfTriangle.push_back(cells
        ? tuples->Ids[static_cast<std::size_t>(converted.CellOfTriangle[t])]
        : Majority(at(c[0]), at(c[1]), at(c[2])));
  }
  return labels;
}
}
