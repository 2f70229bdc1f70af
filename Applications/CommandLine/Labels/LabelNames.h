// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelNames.h
 * @brief What the labels of a label map are called: by its header, by a table that was given, or by
 * one that lies beside it.
 */
#ifndef BoneDecimate_Applications_LabelNames_h
#define BoneDecimate_Applications_LabelNames_h

#include "Arguments/SegmentArguments.h"
#include "Labels/LabelTable.h"

#include "vtkFieldData.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
/// The table of --label-names; empty without the option. @throws Failure(ExitCode::InputRejected)
/// if it cannot be read.
LabelTable TableOfArguments(const SegmentArguments& arguments);

struct LabelNames
{
  LabelTable Table;
  bool AreSegments = false; ///< Labels are segments of the map: one without a voxel is reported.
  std::string Note;         ///< Where names are from, if the map does not hold them.
  std::vector<std::string> Warnings; ///< Tables that were not taken.

  /// Name and color of a label; null if it has none.
  const NamedLabel* Find(std::int64_t label) const;
};

/**
 * Names in the header count first: segments of a segmentation, or a table as TotalSegmentator
 * writes it. Labels without a name there get the names of --label-names. If neither names anything,
 * a file beside the map counts: FindTableBeside().
 * @param fields Field data of the map.
 * @throws Failure(ExitCode::InputRejected) if --label-names contradicts the header.
 */
LabelNames FindLabelNames(
  const std::string& path, vtkFieldData* fields, const SegmentArguments& arguments);

/// The name of a segment whose file names it so: that of the table if the file's says no more than
/// its label.
std::string NameOfSegment(
  std::int64_t label, const std::string& nameInFile, const LabelTable& table);
}

#endif
