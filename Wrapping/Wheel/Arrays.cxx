// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/variant.h>

#include <cstring>

namespace bonedecimate
{
namespace
{
template <typename Value, typename Item>
void Copy(const Value* from, std::vector<Item>& to)
{
  static_assert(sizeof(Item) == 3 * sizeof(Value), "rows lie one after the other");
  if (!to.empty())
  {
    std::memcpy(static_cast<void*>(to.data()), from, to.size() * sizeof(Item));
  }
}
}

//------------------------------------------------------------------------------
Surface ToSurface(const PointsIn& points, const TrianglesIn& triangles)
{
  Surface surface;
  surface.Points.resize(points.shape(0));
  surface.Triangles.resize(triangles.shape(0));
  Copy(points.data(), surface.Points);
  Copy(triangles.data(), surface.Triangles);
  return surface;
}

//------------------------------------------------------------------------------
std::vector<LeftOutShape> ToLeftOut(const LeftOutIn& entries)
{
  std::vector<LeftOutShape> found;
  for (const auto& [kind, count, what, where, corners] : entries)
  {
    LeftOutShape& shape = found.emplace_back();
    shape.Entry.Kind = kind;
    shape.Entry.Count = count;
    shape.Entry.What = what;
    shape.Entry.Where = where;
    shape.Triangles.resize(corners.shape(0));
    const double* from = corners.data();
    for (std::array<Vector3, 3>& triangle : shape.Triangles)
    {
      for (Vector3& corner : triangle)
      {
        corner = Vector3(from[0], from[1], from[2]);
        from += 3;
      }
    }
  }
  return found;
}

//------------------------------------------------------------------------------
std::optional<std::vector<double>> ToNumbers(const std::optional<NumbersIn>& numbers)
{
  if (!numbers)
  {
    return {};
  }
  return std::vector<double>(numbers->data(), numbers->data() + numbers->shape(0));
}

//------------------------------------------------------------------------------
nb::list ToList(const std::vector<ReportEntry>& entries)
{
  nb::list list;
  for (const ReportEntry& entry : entries)
  {
    list.append(nb::make_tuple(entry.Name, entry.Unit, entry.Value));
  }
  return list;
}
}
