// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Values.h
 * @brief JavaScript's typed arrays as vectors of the core and back. Every array is copied once.
 */
#ifndef BoneDecimate_Npm_Values_h
#define BoneDecimate_Npm_Values_h

#include "Base/Monitor.h"
#include "Geometry/Surface.h"

#include <emscripten/val.h>

#include <string>
#include <vector>

namespace bonedecimate
{
using emscripten::val;

/// The numbers of a typed array of any type, or none if it is undefined.
template <typename Number>
std::vector<Number> ToNumbers(const val& array)
{
  std::vector<Number> numbers;
  if (!array.isUndefined())
  {
    numbers.resize(array["length"].as<std::size_t>());
    val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<void>("set", array);
  }
  return numbers;
}

/// Three numbers for each item, one item after the other.
template <typename Number, typename Item>
std::vector<Item> ToRows(const val& array)
{
  static_assert(sizeof(Item) == 3 * sizeof(Number), "rows lie one after the other");
  const std::size_t count = array["length"].as<std::size_t>() / 3;
  std::vector<Item> rows(count);
  if (count > 0)
  {
    val(emscripten::typed_memory_view(3 * count, reinterpret_cast<Number*>(rows.data())))
      .call<void>("set", array);
  }
  return rows;
}

/// A new typed array of the numbers in items of so many.
template <typename Number, typename Item>
val ToArray(const std::vector<Item>& items)
{
  static_assert(sizeof(Item) % sizeof(Number) == 0, "items are numbers one after the other");
  const std::size_t count = items.size() * (sizeof(Item) / sizeof(Number));
  return val(emscripten::typed_memory_view(count, reinterpret_cast<const Number*>(items.data())))
    .call<val>("slice");
}

/// Points and triangles of { points, triangles }.
inline Surface ToSurface(const val& from)
{
  return { ToRows<double, Vector3>(from["points"]), ToRows<Index, Triangle>(from["triangles"]) };
}

val ToTexts(const std::vector<std::string>& texts);

/// Calls progress(fraction); a run is never aborted: its worker is ended instead.
Monitor MonitorOf(const val& progress);
}

#endif
