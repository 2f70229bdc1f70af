// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexRange.h
 * @brief A range of consecutive vertices, which one worker may read and write.
 */
#ifndef BoneDecimate_Core_Mesh_VertexRange_h
#define BoneDecimate_Core_Mesh_VertexRange_h

#include "Geometry/Surface.h"
#include "Handles.h"

#include <cstdint>
#include <limits>

namespace bonedecimate
{
struct VertexRange
{
  Index First = 0;
  Index End = std::numeric_limits<Index>::max(); ///< One past the end.
  /// Whether the range contains all of `count` vertices.
  bool HasAll(Index count) const { return this->First <= 0 && this->End >= count; }
  bool Contains(VertexId v) const
  {
    return static_cast<std::uint32_t>(v - this->First) <
      static_cast<std::uint32_t>(this->End - this->First);
  }
};
}

#endif
