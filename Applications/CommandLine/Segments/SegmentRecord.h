// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentRecord.h
 * @brief What a run made of a segment of a label map.
 */
#ifndef BoneDecimate_Applications_SegmentRecord_h
#define BoneDecimate_Applications_SegmentRecord_h

#include "NamedLabels.h"
#include "VoxelPieces.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
struct SegmentRecord
{
  NamedLabel Label;
  std::int64_t Triangles = 0;
  /// mm3, of each component, the largest first; cavities are negative.
  std::vector<double> Volumes;
  std::optional<ChangedPieces> Changed; ///< Changes before extraction; none: not requested.
  std::string File; ///< File of this segment alone, without folder; empty: none.
  std::int64_t Bytes = 0;
};
}

#endif
