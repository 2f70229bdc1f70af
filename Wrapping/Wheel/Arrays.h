// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Arrays.h
 * @brief numpy arrays from and to the core's vectors. What comes in is copied once, what goes out
 * is handed over.
 */
#ifndef BoneDecimate_Wheel_Arrays_h
#define BoneDecimate_Wheel_Arrays_h

#include "Geometry/Surface.h"
#include "Run/Report/ReportTable.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace bonedecimate
{
namespace nb = nanobind;

template <typename Value, typename... Shape>
using ArrayIn = nb::ndarray<const Value, Shape..., nb::c_contig, nb::device::cpu>;

using PointsIn = ArrayIn<double, nb::shape<-1, 3>>;
using TrianglesIn = ArrayIn<Index, nb::shape<-1, 3>>;
using NumbersIn = ArrayIn<double, nb::ndim<1>>;
using CellsIn = ArrayIn<std::int64_t, nb::ndim<1>>;

using CornersIn = ArrayIn<double, nb::shape<-1, 3, 3>>;
/// Kind, count and noun of each entry, where its first is, and the corners of its triangles, as in
/// LeftOutShape.
using LeftOutIn =
  std::vector<std::tuple<std::string, std::int64_t, std::string, std::string, CornersIn>>;

Surface ToSurface(const PointsIn& points, const TrianglesIn& triangles);
std::vector<LeftOutShape> ToLeftOut(const LeftOutIn& entries);

/// Nothing if there is none.
std::optional<std::vector<double>> ToNumbers(const std::optional<NumbersIn>& numbers);

/// The report as Python sees it: a list of (name, unit, value).
nb::list ToList(const std::vector<ReportEntry>& entries);

/// A numpy array that owns what was in the vector.
template <typename Value, typename Item>
nb::object ToArray(std::vector<Item>&& items, std::initializer_list<std::size_t> shape)
{
  auto* kept = new std::vector<Item>(std::move(items));
  const nb::capsule owner(
    kept, [](void* memory) noexcept { delete static_cast<std::vector<Item>*>(memory); });
  auto* values = reinterpret_cast<Value*>(kept->data());
  return nb::cast(nb::ndarray<nb::numpy, Value>(values, shape, owner));
}

template <typename Value>
nb::object ToArray(std::vector<Value>&& values)
{
  const std::size_t count = values.size();
  return ToArray<Value, Value>(std::move(values), { count });
}

/// One row of three an item.
template <typename Value, typename Item>
nb::object ToRows(std::vector<Item>&& items)
{
  static_assert(sizeof(Item) == 3 * sizeof(Value), "rows lie one after the other");
  const std::size_t count = items.size();
  return ToArray<Value, Item>(std::move(items), { count, 3 });
}
}

#endif
