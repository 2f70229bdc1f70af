// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelFieldOrder.h
 * @brief Names and colors of labels in the order of the labels of a surface.
 */
#ifndef LabelFieldOrder_h
#define LabelFieldOrder_h

#include "Labels/LabelMap/VoxelGrid.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"

#include <cstdint>
#include <limits>

class vtkFieldData;

namespace bonedecimate
{
/// A number of an array as an integer; the lowest of its type if it is none of that type.
template <typename Integer>
Integer ToWhole(double value)
{
  constexpr auto lowest = std::numeric_limits<Integer>::min();
  constexpr auto end = -static_cast<double>(lowest);
  return value >= static_cast<double>(lowest) && value < end ? static_cast<Integer>(value) : lowest;
}

/// Label in an array of any type. It is exact for integers of 64 bits, unlike a double above 2^53.
inline std::int64_t LabelIn(vtkDataArray* array, vtkIdType tuple, int component)
{
  if (auto* exact = vtkAOSDataArrayTemplate<long long>::FastDownCast(array))
  {
    return exact->GetTypedComponent(tuple, component);
  }
  if (auto* exact = vtkAOSDataArrayTemplate<long>::FastDownCast(array))
  {
    return exact->GetTypedComponent(tuple, component);
  }
  return ToWhole<std::int64_t>(array->GetComponent(tuple, component));
}

/// Brings LabelNames and LabelColors of the image, which are in the order of its LabelValues, into
/// the order of the source's values. Rows of values that the image does not name are empty or 0.
/// Without LabelValues in the image they are not changed.
void OrderLabelFields(vtkFieldData* image, const LabelMapSource& source, vtkFieldData* output);
}

#endif
