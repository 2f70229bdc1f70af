// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentSelection.h
 * @brief Which segments of a segmentation are wanted: others cover none of their voxels.
 */
#ifndef BoneDecimate_Applications_SegmentSelection_h
#define BoneDecimate_Applications_SegmentSelection_h

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Why a map in which all voxels are background is rejected. A batch passes over it.
inline constexpr const char* NoLabelReason = "none of its voxels has a label";

struct NamedSegment
{
  std::int64_t Label;
  std::string Name; ///< In the file.
};

/// For each of all segments of a file, whether it is wanted. Empty: all are.
using SegmentSelection = std::function<std::vector<bool>(const std::vector<NamedSegment>& all)>;
}

#endif
