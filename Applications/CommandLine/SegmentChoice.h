// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentChoice.h
 * @brief The segments of a label map, and which of them a text chooses.
 */
#ifndef BoneDecimate_Applications_SegmentChoice_h
#define BoneDecimate_Applications_SegmentChoice_h

#include "NamedLabels.h"
#include "SegmentArguments.h"

#include "vtkImageData.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Adds the labels of the voxels but 0; not all of them if they are so many that they are gray values.
void CollectLabels(vtkImageData* map, std::set<std::int64_t>& labels);

/**
 * The labels of the voxels but 0, ascending, with the names and colors of the map or of TotalSegmentator.
 * @param labels CollectLabels() of all voxels.  @param fields Of the map.  @param path Of the map, for messages.
 * @throws Failure(ExitCode::InputRejected) if there are none, or so many that they are gray values.
 */
std::vector<NamedLabel> FindSegments(const std::set<std::int64_t>& labels, vtkFieldData* fields,
  const SegmentArguments& arguments, const std::string& path);
/// Of a map in memory.
std::vector<NamedLabel> FindSegments(
  vtkImageData* map, const SegmentArguments& arguments, const std::string& path);

/**
 *     all       every one
 *     bones     with names of TotalSegmentator: those that it knows as bones
 *     else      labels and names with commas in between; small and capital letters are the same
 *
 * @throws Failure(ExitCode::InputRejected) with the segments that there are, if one of them is not there.
 */
std::vector<NamedLabel> ChooseSegments(const std::vector<NamedLabel>& segments,
  const SegmentArguments& arguments, const std::string& path);
}

#endif
