// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelTable.h
 * @brief Names and colors of labels from a file of their own, or from the header of a label map.
 */
#ifndef BoneDecimate_Applications_LabelTable_h
#define BoneDecimate_Applications_LabelTable_h

#include "NamedLabels.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Bytes of a file that a message quotes at most.
inline constexpr std::size_t LongestQuote = 40;

/// The labels of each region, by its name in lower case.
using LabelRegions = std::map<std::string, std::vector<std::int64_t>>;

struct LabelTable
{
  std::vector<NamedLabel> Labels; ///< Without the background, 0; ascending.
  LabelRegions Regions;
  std::string Problem;  ///< Why there is no table, a clause; empty if there is one.
  bool IsOther = false; ///< The problem is at the begin: the file may be anything.

  bool IsEmpty() const { return this->Labels.empty() && this->Regions.empty(); }
};

/// The extensions of files that ReadLabelTable() reads, in words.
inline constexpr const char* LabelTableExtensions = ".json, .tsv, .csv, .ctbl, .txt or .label";

/// The table of any of the formats below, which it knows by its content. Names are plain text.
LabelTable ReadLabelTable(const std::string& path);

/**
 * The `labels` of nnU-Net's dataset.json: a number or a list of numbers for each name, or, as in
 * its first version, a name for each number. A file that has none is empty.
 */
LabelTable ReadLabelsOfJson(const std::string& text);

/**
 *     index <tab> name                  with a heading, as BIDS has it; columns color (#rrggbb) or,
 *                                       of 3D Slicer's .csv, Color_R ...
 *     1 255 0 0 1 1 1 "Left femur"      label descriptions of ITK-SNAP
 *     1 Left_femur 255 0 0 255          color tables of 3D Slicer and FreeSurfer
 */
LabelTable ReadLabelsOfText(const std::string& text);

/// The table in the header of a NIfTI file, as TotalSegmentator and Connectome Workbench write it;
/// of any other file an empty one.
LabelTable ReadLabelsOfHeader(const std::string& path);

/// Sorts the labels. A label that has two names is a problem.
void CompleteTable(LabelTable& table);
}

#endif
