// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Segmentation.h
 * @brief What a segmentation says about its segments, in a .seg.nrrd of 3D Slicer, and overlapping
 * segments as one label map.
 */
#ifndef BoneDecimate_Applications_Segmentation_h
#define BoneDecimate_Applications_Segmentation_h

#include "SegmentSelection.h"
#include "Volume.h"

#include "vtkFieldData.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// A segment as the header describes it.
struct Segment
{
  std::int64_t Label = 1; ///< Value of its voxels.
  std::int64_t Layer = 0; ///< Layer of the file; overlapping segments are in different layers.
  std::string Name;
  std::array<double, 3> Color{ { 0.5, 0.5, 0.5 } }; ///< Red, green and blue, 0 to 1.
};

/// What does not fit when segments become one label map.
struct Overlap
{
  std::int64_t Voxels = 0;      ///< Number of voxels in more than one segment.
  std::int64_t Undescribed = 0; ///< Number of voxels whose value belongs to no segment.
};

/// Tells the user of voxels in more than one segment; empty if there are none.
std::string OverlapNote(const Overlap& overlap);

/// Error message for values that belong to no segment; empty if there are none.
std::string UndescribedProblem(const Overlap& overlap);

/// @param textOf The text of a key of the header, empty if it is not there: "Segment0_Name" and so
///   on.
std::vector<Segment> ReadSegments(const std::function<std::string(const std::string&)>& textOf);

/**
 * Makes one label map of a volume whose voxels have a value for each layer. Of several segments the
 * last one counts, as when 3D Slicer exports them to a label map. If labels repeat, the segments
 * get the labels from 1 on. A note says both.
 * @param selection Segments that are not wanted cover no others; their voxels are background.
 */
Volume CombinedLayers(
  const Volume& layers, std::vector<Segment> segments, const SegmentSelection& selection = {});

/// For each segment, whether it is selected.
std::vector<bool> ChosenSegments(
  const std::vector<Segment>& segments, const SegmentSelection& selection);

/// Adds the field arrays LabelValues, LabelNames and LabelColors, if there are segments.
void AddLabelFields(const std::vector<Segment>& segments, vtkFieldData* fields);
}

#endif
