// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelImage.h
 * @brief A label map in memory: an integer for each voxel, of any type.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_LabelImage_h
#define BoneDecimate_Core_Labels_LabelMap_LabelImage_h

#include "VoxelGrid.h"

#include <cstdint>
#include <type_traits>

namespace bonedecimate
{
enum class LabelType : int
{
  Int8 = 0,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64
};

struct LabelImage
{
  const void* Labels = nullptr; ///< Contiguous, x fastest, then y; as many as the grid has voxels.
  LabelType Type = LabelType::UInt8;
  VoxelGrid Grid;
};

/// Layers of a grid along its third axis.
struct LayerRange
{
  Index First = 0;
  Index Last = 0;

  Index Count() const { return this->Last - this->First + 1; }
};

/// The type with the size and the sign of the scalar.
template <typename Scalar>
constexpr LabelType LabelTypeOf()
{
  static_assert(std::is_integral_v<Scalar>, "labels are integers");
  constexpr int size = sizeof(Scalar) == 1 ? 0
    : sizeof(Scalar) == 2                  ? 2
    : sizeof(Scalar) == 4                  ? 4
                                           : 6;
  return static_cast<LabelType>(size + (std::is_signed_v<Scalar> ? 0 : 1));
}

template <typename Scalar>
LabelImage MakeLabelImage(const Scalar* labels, const VoxelGrid& grid)
{
  return { labels, LabelTypeOf<Scalar>(), grid };
}

/// Calls work(labels) with a pointer of their type.
template <typename Work>
auto WithLabelsOf(const LabelImage& image, const Work& work)
{
  switch (image.Type)
  {
    case LabelType::Int8:
      return work(static_cast<const std::int8_t*>(image.Labels));
    case LabelType::UInt8:
      return work(static_cast<const std::uint8_t*>(image.Labels));
    case LabelType::Int16:
      return work(static_cast<const std::int16_t*>(image.Labels));
    case LabelType::UInt16:
      return work(static_cast<const std::uint16_t*>(image.Labels));
    case LabelType::Int32:
      return work(static_cast<const std::int32_t*>(image.Labels));
    case LabelType::UInt32:
      return work(static_cast<const std::uint32_t*>(image.Labels));
    case LabelType::Int64:
      return work(static_cast<const std::int64_t*>(image.Labels));
    case LabelType::UInt64:
    default:
      return work(static_cast<const std::uint64_t*>(image.Labels));
  }
}
}

#endif
