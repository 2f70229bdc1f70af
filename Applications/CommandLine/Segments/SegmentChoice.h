// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentChoice.h
 * @brief The segments of a label map, and which of them a text chooses.
 */
#ifndef BoneDecimate_Applications_SegmentChoice_h
#define BoneDecimate_Applications_SegmentChoice_h

#include "Arguments/SegmentArguments.h"
#include "Figures/LeftOut.h"
#include "LabelMaps/SegmentSelection.h"
#include "Labels/LabelTable.h"
#include "NamedLabels.h"

#include "vtkImageData.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Adds the labels of the voxels but 0; not all of them if they are so many that they are gray
/// values.
void CollectLabels(vtkImageData* map, std::set<std::int64_t>& labels);

/// What there is to choose from.
struct FoundSegments
{
  /// The labels of the voxels but 0, ascending, with names and colors.
  std::vector<NamedLabel> Present;
  std::vector<NamedLabel> Empty; ///< Labels that are described and that no voxel has.
  bool AreDescribed = false;     ///< The map describes its labels; off: a table for many maps does.
  LabelRegions Regions;          ///< Names of several labels.
  std::string Note;              ///< Where names are from; may be empty.
  std::vector<std::string> Warnings;
};

/// Begin of a sentence like NoLabelReason, about segments that were chosen.
inline constexpr const char* NoChosenVoxelReason = "no voxel belongs to what --segments chooses, ";

/**
 * Names and colors are those of FindLabelNames().
 * @param labels CollectLabels() of all voxels.  @param fields Field data of the map.
 * @param path Path of the map, for messages.
 * @throws Failure(ExitCode::InputRejected) if there are none, or so many that they are gray values.
 */
FoundSegments FindSegments(const std::set<std::int64_t>& labels, vtkFieldData* fields,
  const SegmentArguments& arguments, const std::string& path);
/// Finds the segments of a map in memory.
FoundSegments FindSegments(
  vtkImageData* map, const SegmentArguments& arguments, const std::string& path);

/**
 *     all       every one
 *     bones     those with the name of a bone; also vertebrae, pelvis, skull (SegmentPresets.h)
 *     else      labels and names with commas in between; small and capital letters are the same
 *
 * @param warnings Get those of the segments, and a sentence with the chosen ones that have no
 *   voxel.
 * @throws Failure(ExitCode::InputRejected) with the segments that there are, if one of them is not
 *   there, or none has a voxel.
 */
std::vector<NamedLabel> ChooseSegments(const FoundSegments& segments,
  const SegmentArguments& arguments, const std::string& path, std::vector<std::string>& warnings);

/// The segments that were not chosen, as the report lists what was left out; none if there are
/// none.
std::vector<LeftOut> SegmentsLeftOut(const FoundSegments& segments,
  const SegmentArguments& arguments, const std::vector<NamedLabel>& chosen);

/// The choice before the map is read, so that segments that were not chosen cover no other ones.
SegmentSelection SelectionOf(const SegmentArguments& arguments, const std::string& path);
}

#endif
